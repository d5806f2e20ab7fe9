// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include <vector>

#include "cad2slam/map/occupancy_grid.h"
#include "cad2slam/simulation/seeded_random.h"
#include "cad2slam/simulation/site_plan.h"

namespace cad2slam::samples {

/// A building as a robot finds it: with furniture, and with doors that stand open or are shut. Plan frame.
struct FurnishedWorld {
  OccupancyGrid grid;
  std::vector<bool> door_is_open;  ///< for each door of the plan
};

[[nodiscard]] FurnishedWorld furnish(const SitePlan& plan, SeededRandom& random);

/// The robot's way: along the plan's route and into every room with an open door, as far as it fits through.
/// Poses `spacing_m` apart.
[[nodiscard]] std::vector<Pose2> driveThrough(const SitePlan& plan, const FurnishedWorld& world, double spacing_m,
                                              SeededRandom& random);

}  // namespace cad2slam::samples
