// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QProxyStyle>

namespace cad2slam {

/// Fusion with check boxes that are seen: its frames are a shade of the window, which on a dark one is none, and in a
/// selected row its tick takes the colour of the row's text.
class ClearBoxes : public QProxyStyle {
  Q_OBJECT

 public:
  ClearBoxes();

  void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override;
};

}  // namespace cad2slam
