// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "cad2slam/geometry/pose2.h"

namespace cad2slam {

/// One direction of a projector, sampled on a regular grid that is upright in the source frame. For readers that know
/// nothing but bilinear interpolation.
struct PoseGrid {
  std::size_t rows = 0;  ///< row 0 lies at the smallest y
  std::size_t columns = 0;
  double step_m = 0.0;
  Eigen::Vector2d first = Eigen::Vector2d::Zero();  ///< place of row 0, column 0 [m]
  /// [rows][columns]: image of the place, and how much a heading of 0 is turned there [rad]. NaN where nothing is.
  std::vector<Pose2> images;
  double max_deviation_m = 0.0;  ///< of bilinear interpolation, where all four corners are there

  [[nodiscard]] const Pose2& at(std::size_t row, std::size_t column) const { return images[row * columns + column]; }
};

}  // namespace cad2slam
