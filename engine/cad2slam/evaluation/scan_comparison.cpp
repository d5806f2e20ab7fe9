// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/evaluation/scan_comparison.h"

#include "cad2slam/evaluation/error_statistics.h"
#include "cad2slam/evaluation/parallel_for.h"
#include "cad2slam/simulation/seeded_random.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <string>

namespace cad2slam {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

/// Distance of each projected hit to the nearest hit in the SLAM map.
struct ScanDistances {
  std::vector<double> nearest_m;
};

ScanDistances compareAt(const Projector& projector, const OccupancyGrid& blueprint, const OccupancyGrid& slam,
                        const Pose2& in_blueprint, const Pose2& in_slam, const ScanOptions& options) {
  LidarModel blueprint_lidar = options.lidar;
  blueprint_lidar.range_max_m /= projector.info().scale;
  const Scan expected = simulateScan(blueprint, in_blueprint, blueprint_lidar);
  const std::vector<Eigen::Vector2d> seen = simulateScan(slam, in_slam, options.lidar).hits(in_slam);
  ScanDistances distances;
  for (const Eigen::Vector2d& hit : expected.hits(in_blueprint)) {
    const Projection projected = projector.slamFromBlueprint({hit, 0.0}, OutsidePolicy::kRigid);
    double nearest = kNever;
    if (projected.ok()) {
      for (const Eigen::Vector2d& other : seen) {
        nearest = std::min(nearest, (other - projected.pose.translation).squaredNorm());
      }
    }
    distances.nearest_m.push_back(std::sqrt(nearest));
  }
  return distances;
}

ScanAgreement agreementOf(const std::vector<ScanDistances>& scans, double threshold_m) {
  ScanAgreement agreement;
  agreement.threshold_m = threshold_m;
  std::vector<double> means;
  for (const ScanDistances& scan : scans) {
    double sum = 0.0;
    double squares = 0.0;
    int inliers = 0;
    for (const double distance : scan.nearest_m) {
      if (distance > threshold_m) continue;
      ++inliers;
      sum += distance;
      squares += distance * distance;
    }
    if (inliers > 0) means.push_back(sum / inliers);
    agreement.outliers += (static_cast<double>(scan.nearest_m.size()) - inliers) / static_cast<double>(scans.size());
    agreement.sum_of_squares_m2 += squares / static_cast<double>(scans.size());
  }
  const ErrorStatistics statistics = summarise(std::move(means));
  agreement.mean_m = statistics.mean;
  agreement.deviation_m = statistics.deviation;
  return agreement;
}

std::vector<ScanAgreement> agreements(const std::vector<ScanDistances>& scans, const ScanOptions& options) {
  std::vector<ScanAgreement> all;
  for (const double threshold : options.thresholds_m) {
    all.push_back(agreementOf(scans, threshold));
  }
  return all;
}

Result<ComparedPath> planAndProject(const Projector& projector, const OccupancyGrid& blueprint, const StartGoal& ends,
                                    const PlannerSettings& settings, std::size_t number) {
  Result<PlannedPath> path = planPath(blueprint, ends.start, ends.goal, settings);
  if (!path) return fail(path.error().code, path.error().message, "path " + std::to_string(number));
  ComparedPath compared;
  compared.ends = ends;
  compared.in_blueprint = std::move(*path);
  for (const Pose2& pose : compared.in_blueprint.poses) {
    const Projection projected = projector.slamFromBlueprint(pose, OutsidePolicy::kRigid);
    if (!projected.ok()) {
      return fail(ErrorCode::kDegenerate, "the mesh folds on the way, so the path cannot be projected",
                  "path " + std::to_string(number));
    }
    compared.in_slam.push_back(projected.pose);
  }
  return compared;
}

}  // namespace

Result<ScanComparison> compareScans(const Projector& projector, const OccupancyGrid& blueprint,
                                    const OccupancyGrid& slam, const std::vector<StartGoal>& ends,
                                    const ScanOptions& options) {
  if (options.lidar.beams < 1 || !(options.lidar.range_max_m > 0.0)) {
    return fail(ErrorCode::kOutOfDomain, "The LiDAR needs at least one beam and a positive range");
  }
  ScanComparison comparison;
  std::vector<ScanDistances> all;
  double hits = 0.0;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    Result<ComparedPath> path = planAndProject(projector, blueprint, ends[i], options.planner, i + 1);
    if (!path) return failAs(path);
    const std::size_t count = path->in_slam.size();
    std::vector<ScanDistances> scans(count);
    parallelFor(count, options.threads, [&](unsigned, std::size_t k) {
      scans[k] = compareAt(projector, blueprint, slam, path->in_blueprint.poses[k], path->in_slam[k], options);
    });
    for (const ScanDistances& scan : scans) {
      const ErrorStatistics statistics = summarise(scan.nearest_m);
      path->median_distance_m.push_back(statistics.count > 0 ? statistics.median : kNever);
      hits += static_cast<double>(scan.nearest_m.size());
    }
    path->agreement = agreements(scans, options);
    comparison.paths.push_back(std::move(*path));
    all.insert(all.end(), std::make_move_iterator(scans.begin()), std::make_move_iterator(scans.end()));
    if (options.on_progress) options.on_progress(i + 1, ends.size());
  }
  comparison.scans = all.size();
  comparison.agreement = agreements(all, options);
  comparison.beams_without_hit = all.empty() ? 0.0 : options.lidar.beams - hits / static_cast<double>(comparison.scans);
  return comparison;
}

Result<std::vector<StartGoal>> randomStartGoals(const OccupancyGrid& blueprint, int count,
                                                const PlannerSettings& planner, std::uint64_t seed) {
  const MapFrame& frame = blueprint.frame();
  SeededRandom random(seed);
  const auto random_place = [&] {
    return frame.metricFromPixel({random.uniform(0.0, frame.width()), random.uniform(0.0, frame.height())});
  };
  constexpr int kPlacesPerPath = 20'000;
  constexpr int kPlansPerPath = 20;
  int places_left = kPlacesPerPath * std::max(count, 1);
  int plans_left = kPlansPerPath * std::max(count, 1);
  std::vector<StartGoal> ends;
  while (static_cast<int>(ends.size()) < count && places_left > 0 && plans_left > 0) {
    --places_left;
    const StartGoal candidate{random_place(), random_place()};
    if (blueprint.at(candidate.start) != CellState::kFree || blueprint.at(candidate.goal) != CellState::kFree) continue;
    const bool nearly_exhausted = places_left < kPlacesPerPath / 2;
    if (!nearly_exhausted && (candidate.start - candidate.goal).norm() < 0.25 * frame.diagonal()) continue;
    --plans_left;
    if (planPath(blueprint, candidate.start, candidate.goal, planner)) ends.push_back(candidate);
  }
  if (ends.empty()) return fail(ErrorCode::kDegenerate, "The blueprint has too little free space for a path");
  return ends;
}

}  // namespace cad2slam
