// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>

#include <string>
#include <vector>

#include "cad2slam/core/result.h"
#include "cad2slam/map/occupancy_grid.h"

namespace cad2slam {

/// A number known at a place of a map.
struct PlacedValue {
  Eigen::Vector2d place = Eigen::Vector2d::Zero();  ///< [m] in the map's frame
  double value = 0.0;
};

/// A map with coloured squares of `size_m` at places, walls above them, and the scale of colours below. Colours end at
/// the 99th percentile. CV_8UC3, at most `largest_side_px` on the longer side.
[[nodiscard]] Result<cv::Mat> drawValueMap(const OccupancyGrid& map, const std::vector<PlacedValue>& values,
                                           double size_m, const std::string& unit, int largest_side_px = 1400);

/// A map with ways that are coloured by a number at each place, e.g. how well scans agree there. A ring
/// marks the start, a red disc the goal.
[[nodiscard]] Result<cv::Mat> drawWays(const OccupancyGrid& map, const std::vector<std::vector<PlacedValue>>& ways,
                                       const std::string& unit, int largest_side_px = 1400);

}  // namespace cad2slam
