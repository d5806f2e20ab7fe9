// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include <vector>

#include "cad2slam/core/result.h"
#include "cad2slam/geometry/pose2.h"
#include "cad2slam/map/occupancy_grid.h"

namespace cad2slam {

struct PlannerSettings {
  double robot_radius_m = 0.0;      ///< pixels nearer than this to anything not free are closed
  double wanted_clearance_m = 0.5;  ///< being nearer than this to a wall costs extra
  double clearance_cost = 3.0;      ///< how much longer a way may be to keep the wanted clearance; 0: shortest path
  double step_m = 0.1;              ///< distance between the poses of the returned path
};

struct PlannedPath {
  std::vector<Pose2> poses;  ///< map frame; headings along the path; first is the start, last is the goal
  double length_m = 0.0;
  /// Cost of the best way on the 8-connected grid between the pixels of start and goal: its length [m], each metre
  /// counted up to 1 + clearance_cost times near walls. The returned path is never dearer than that way and the steps
  /// from both ends to the centres of their pixels.
  double grid_cost_m = 0.0;
};

/// Finds a way over free pixels with A* on the 8-connected grid (no cutting of corners) and shortens it to any angle
/// where nothing but free space (and no lost clearance) lies in between. Outside of the raster nothing is free.
/// kOutOfDomain: start or goal is outside the map, not free or nearer than the robot's radius to a wall, or a setting
/// is no length; kDegenerate: no path between them. A map of more than 25 million pixels is searched on a coarser grid,
/// on which a pixel is free only where all it stands for are.
[[nodiscard]] Result<PlannedPath> planPath(const OccupancyGrid& map, const Eigen::Vector2d& start_m,
                                           const Eigen::Vector2d& goal_m, const PlannerSettings& settings = {});

}  // namespace cad2slam
