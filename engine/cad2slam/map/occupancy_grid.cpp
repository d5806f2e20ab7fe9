// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/map/occupancy_grid.h"

#include <stdexcept>
#include <utility>

namespace cad2slam {

OccupancyGrid::OccupancyGrid(const MapFrame& frame, cv::Mat states) : frame_(frame), states_(std::move(states)) {
  if (states_.type() != CV_8UC1 || states_.cols != frame_.width() || states_.rows != frame_.height()) {
    throw std::invalid_argument("OccupancyGrid: the states do not fit the frame");
  }
}

CellState OccupancyGrid::at(const Eigen::Vector2d& point_m) const {
  const Eigen::Vector2d pixel = frame_.pixelFromMetric(point_m);
  // Compared as doubles: a far-away or non-finite point must not be cast to int.
  const bool inside = pixel.x() >= 0.0 && pixel.y() >= 0.0 && pixel.x() < frame_.width() && pixel.y() < frame_.height();
  return inside ? at(static_cast<int>(pixel.x()), static_cast<int>(pixel.y())) : CellState::kUnknown;
}

}  // namespace cad2slam
