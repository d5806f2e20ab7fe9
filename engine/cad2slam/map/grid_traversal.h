// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include <cmath>
#include <limits>

namespace cad2slam {

/// Walks the pixels that a ray passes, in order and without leaving one out (Amanatides and Woo 1987).
/// The ray is start + t * direction in the pixel frame, t >= 0; `direction` need not be a unit vector, so that t may
/// count metres. Borders are computed from whole pixel numbers each time: a long ray gathers no rounding error.
class GridTraversal {
 public:
  GridTraversal(const Eigen::Vector2d& start_px, const Eigen::Vector2d& direction_px)
      : GridTraversal(start_px, direction_px, static_cast<int>(std::floor(start_px.x())),
                      static_cast<int>(std::floor(start_px.y())), 0.0) {}

  /// Begins in a given pixel that the ray enters at `entered`, for rays that start outside of a raster.
  GridTraversal(const Eigen::Vector2d& start_px, const Eigen::Vector2d& direction_px, int column, int row,
                double entered)
      : start_(start_px), column_(column), row_(row), entered_(entered) {
    step_column_ = direction_px.x() > 0.0 ? 1 : -1;
    step_row_ = direction_px.y() > 0.0 ? 1 : -1;
    per_column_ = direction_px.x() == 0.0 ? kNever : 1.0 / direction_px.x();
    per_row_ = direction_px.y() == 0.0 ? kNever : 1.0 / direction_px.y();
    next_column_ = columnBorder();
    next_row_ = rowBorder();
  }

  [[nodiscard]] int column() const { return column_; }
  [[nodiscard]] int row() const { return row_; }
  [[nodiscard]] double entered() const { return entered_; }  ///< t at which the ray came into the current pixel
  [[nodiscard]] double leaves() const { return next_column_ < next_row_ ? next_column_ : next_row_; }
  /// The ray leaves exactly through a corner; the traversal then also visits the pixel of the next row beside it.
  [[nodiscard]] bool leavesThroughCorner() const { return next_column_ == next_row_; }

  void advance() {
    if (next_column_ < next_row_) {
      entered_ = next_column_;
      column_ += step_column_;
      next_column_ = columnBorder();
    } else {
      entered_ = next_row_;
      row_ += step_row_;
      next_row_ = rowBorder();
    }
  }

  [[nodiscard]] int columnStep() const { return step_column_; }
  [[nodiscard]] int rowStep() const { return step_row_; }

 private:
  static constexpr double kNever = std::numeric_limits<double>::infinity();

  [[nodiscard]] double columnBorder() const {
    return per_column_ == kNever ? kNever : (column_ + (step_column_ > 0 ? 1 : 0) - start_.x()) * per_column_;
  }
  [[nodiscard]] double rowBorder() const {
    return per_row_ == kNever ? kNever : (row_ + (step_row_ > 0 ? 1 : 0) - start_.y()) * per_row_;
  }

  Eigen::Vector2d start_;
  int column_;
  int row_;
  int step_column_;
  int step_row_;
  double per_column_;
  double per_row_;
  double next_column_;
  double next_row_;
  double entered_;
};

}  // namespace cad2slam
