// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cad2slam/map/occupancy_grid.h"

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

#include <optional>
#include <vector>

namespace cad2slam {

/// The rooms of a blueprint: pieces of free space that fall apart when everything narrower than a door is closed. Good
/// enough to say "this room has no anchor", not to count rooms for the land registry.
class RoomMap {
 public:
  struct Room {
    double area_m2 = 0.0;
    Eigen::Vector2d center = Eigen::Vector2d::Zero();  ///< [m] a place inside, far from the walls
  };

  /// Looks at the blueprint at about 10 cm for each pixel; takes some 100 ms for a large one, so run it in a worker.
  [[nodiscard]] static RoomMap find(const OccupancyGrid& blueprint);

  [[nodiscard]] const std::vector<Room>& rooms() const { return rooms_; }
  /// Index of the room a place [m] lies in or next to; empty far from any.
  [[nodiscard]] std::optional<std::size_t> roomAt(const Eigen::Vector2d& point_m) const;

 private:
  explicit RoomMap(const MapFrame& frame) : frame_(frame) {}

  MapFrame frame_;  // of the labels
  cv::Mat labels_;  // CV_32SC1; 0 is no room, i + 1 is room i
  std::vector<Room> rooms_;
};

}  // namespace cad2slam
