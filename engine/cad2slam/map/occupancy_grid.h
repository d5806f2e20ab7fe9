// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>

#include <cstdint>

#include "cad2slam/map/map_frame.h"

namespace cad2slam {

/// What map_server says of one pixel.
enum class CellState : std::uint8_t { kFree = 0, kOccupied = 1, kUnknown = 2 };

/// A raster of free, occupied and unknown pixels with its metric frame. Copies share the pixels, which are never
/// written after construction.
class OccupancyGrid {
 public:
  /// `states`: CV_8UC1 of CellState values, as large as the frame; anything else is a broken contract.
  OccupancyGrid(const MapFrame& frame, cv::Mat states);

  [[nodiscard]] const MapFrame& frame() const { return frame_; }
  [[nodiscard]] const cv::Mat& states() const { return states_; }
  /// Outside the raster everything is unknown.
  [[nodiscard]] CellState at(int column, int row) const {
    if (column < 0 || row < 0 || column >= states_.cols || row >= states_.rows) return CellState::kUnknown;
    return static_cast<CellState>(states_.ptr<std::uint8_t>(row)[column]);
  }
  [[nodiscard]] CellState at(const Eigen::Vector2d& point_m) const;

 private:
  MapFrame frame_;
  cv::Mat states_;
};

}  // namespace cad2slam
