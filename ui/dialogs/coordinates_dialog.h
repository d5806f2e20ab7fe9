// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cad2slam/anchors/anchor.h"

#include <QDialog>

#include <array>

class QLineEdit;
class QPushButton;

namespace cad2slam {

/// Both places of an anchor as numbers, for a new anchor or one that exists.
class CoordinatesDialog : public QDialog {
  Q_OBJECT

 public:
  /// `anchor`: the one to change, or null for a new one, which will get the number `next_id`.
  CoordinatesDialog(QWidget* parent, const Anchor* anchor, AnchorId next_id);

  [[nodiscard]] Eigen::Vector2d inBlueprint() const;
  [[nodiscard]] Eigen::Vector2d inSlam() const;

 private:
  void refresh();
  [[nodiscard]] double value(std::size_t at) const;

  std::array<QLineEdit*, 4> fields_{};
  std::array<QString, 4> texts_{};  // as first shown
  std::array<double, 4> values_{};  // behind them, with all digits
  QPushButton* ok_;
};

}  // namespace cad2slam
