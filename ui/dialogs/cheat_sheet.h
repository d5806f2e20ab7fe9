// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDialog>

namespace cad2slam {

class Actions;

/// All keys and mouse gestures on one page.
class CheatSheet : public QDialog {
  Q_OBJECT

 public:
  CheatSheet(QWidget* parent, const Actions& actions);
};

}  // namespace cad2slam
