// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include <vector>

#include "cad2slam/geometry/pose2.h"
#include "cad2slam/map/occupancy_grid.h"

namespace cad2slam {

/// A 2D LiDAR. Beam k points at heading + start_angle + k * fov / beams.
struct LidarModel {
  int beams = 360;
  double field_of_view_rad = 2.0 * kPi;
  double start_angle_rad = -kPi;
  double range_max_m = 20.0;
  bool stops_at_unknown = false;  ///< beams also end where they enter unknown space, the outside of the raster included
};

/// One sweep: a beam that met nothing within the range has an infinite range.
struct Scan {
  std::vector<double> ranges_m;
  std::vector<double> bearings_rad;  ///< in the sensor's frame
  /// Places of the hits in the map frame [m]; beams without a hit are left out.
  [[nodiscard]] std::vector<Eigen::Vector2d> hits(const Pose2& map_from_sensor) const;
};

/// Casts every beam through the grid by exact cell traversal (Amanatides and Woo 1987) and stops where the beam enters
/// the first occupied pixel. Unknown pixels are passed unless the model says otherwise. A sensor inside a pixel that
/// stops beams measures 0 everywhere.
[[nodiscard]] Scan simulateScan(const OccupancyGrid& map, const Pose2& map_from_sensor, const LidarModel& model);

}  // namespace cad2slam
