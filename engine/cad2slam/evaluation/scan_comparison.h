// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "cad2slam/core/result.h"
#include "cad2slam/evaluation/anchor_errors.h"
#include "cad2slam/map/occupancy_grid.h"
#include "cad2slam/planning/grid_planner.h"
#include "cad2slam/planning/start_goal.h"
#include "cad2slam/projection/projector.h"
#include "cad2slam/simulation/lidar_simulator.h"

namespace cad2slam {

/// The paper's section IV-A. A path is planned on the blueprint and projected. At each of its poses a scan is simulated
/// in the blueprint and, at the projected pose, one in the SLAM map. The hits of the blueprint's scan are projected,
/// and each is compared with the nearest hit of the SLAM map's scan (eq. 5).
struct ScanOptions {
  LidarModel lidar;  ///< range in SLAM metres; the blueprint's is divided by the scale of the projector
  std::vector<double> thresholds_m = {0.01, 0.05, 0.1, 0.5};
  PlannerSettings planner;
  unsigned threads = 0;
  ProgressCallback on_progress;
};

/// Agreement of scans at one threshold.
struct ScanAgreement {
  double threshold_m = 0.0;
  /// Mean over the scans of the mean distance [m] of those points that are within the threshold.
  double mean_m = 0.0;
  double deviation_m = 0.0;  ///< of those means, from scan to scan
  /// Mean number of points in a scan of the blueprint that have no counterpart within the threshold. A beam that meets
  /// nothing in the blueprint makes no point: inliers, outliers and those add up to the number of beams.
  double outliers = 0.0;
  double sum_of_squares_m2 = 0.0;  ///< E of eq. 5 over the inliers, mean of the scans
};

struct ComparedPath {
  StartGoal ends;
  PlannedPath in_blueprint;
  std::vector<Pose2> in_slam;
  std::vector<ScanAgreement> agreement;   ///< one for each threshold
  std::vector<double> median_distance_m;  ///< of each scan; infinite where nothing was met
};

struct ScanComparison {
  std::vector<ComparedPath> paths;
  std::vector<ScanAgreement> agreement;  ///< over the scans of all paths
  std::size_t scans = 0;
  double beams_without_hit = 0.0;  ///< mean of a scan in the blueprint
};

/// Errors of planning name the path by its number.
[[nodiscard]] Result<ScanComparison> compareScans(const Projector& projector, const OccupancyGrid& blueprint,
                                                  const OccupancyGrid& slam, const std::vector<StartGoal>& ends,
                                                  const ScanOptions& options);

/// Pairs of free places with a path between them, at least a quarter of the diagonal apart where the building allows.
/// kDegenerate: too little free space.
[[nodiscard]] Result<std::vector<StartGoal>> randomStartGoals(const OccupancyGrid& blueprint, int count,
                                                              const PlannerSettings& planner, std::uint64_t seed);

}  // namespace cad2slam
