// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/simulation/lidar_simulator.h"

#include "cad2slam/map/grid_traversal.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cad2slam {
namespace {

constexpr double kNoHit = std::numeric_limits<double>::infinity();

/// Part of a ray that lies inside a raster; empty when `leave` <= `enter`.
struct RayInterval {
  double enter = 0.0;
  double leave = kNoHit;
};

void clipAxis(double start, double direction, double size, RayInterval& interval) {
  if (direction == 0.0) {
    if (start < 0.0 || start >= size) interval.leave = -1.0;
    return;
  }
  const double to_low = (0.0 - start) / direction;
  const double to_high = (size - start) / direction;
  interval.enter = std::max(interval.enter, std::min(to_low, to_high));
  interval.leave = std::min(interval.leave, std::max(to_low, to_high));
}

bool stopsBeam(CellState state, const LidarModel& model) {
  return state == CellState::kOccupied || (model.stops_at_unknown && state == CellState::kUnknown);
}

double castRay(const OccupancyGrid& map, const Eigen::Vector2d& start_px, const Eigen::Vector2d& px_per_m,
               const LidarModel& model) {
  const int width = map.frame().width();
  const int height = map.frame().height();
  RayInterval inside{0.0, model.range_max_m};
  clipAxis(start_px.x(), px_per_m.x(), width, inside);
  clipAxis(start_px.y(), px_per_m.y(), height, inside);
  if (!(inside.leave >= inside.enter)) return kNoHit;

  const Eigen::Vector2d first = start_px + inside.enter * px_per_m;
  const int column = std::clamp(static_cast<int>(std::floor(first.x())), 0, width - 1);
  const int row = std::clamp(static_cast<int>(std::floor(first.y())), 0, height - 1);
  for (GridTraversal ray(start_px, px_per_m, column, row, inside.enter); ray.entered() <= model.range_max_m;
       ray.advance()) {
    if (ray.column() < 0 || ray.row() < 0 || ray.column() >= width || ray.row() >= height) {
      return model.stops_at_unknown ? ray.entered() : kNoHit;
    }
    if (stopsBeam(map.at(ray.column(), ray.row()), model)) return ray.entered();
  }
  return kNoHit;
}

}  // namespace

std::vector<Eigen::Vector2d> Scan::hits(const Pose2& map_from_sensor) const {
  std::vector<Eigen::Vector2d> points;
  points.reserve(ranges_m.size());
  for (std::size_t beam = 0; beam < ranges_m.size(); ++beam) {
    if (!std::isfinite(ranges_m[beam])) continue;
    const double bearing = map_from_sensor.heading + bearings_rad[beam];
    points.push_back(map_from_sensor.translation +
                     ranges_m[beam] * Eigen::Vector2d(std::cos(bearing), std::sin(bearing)));
  }
  return points;
}

Scan simulateScan(const OccupancyGrid& map, const Pose2& map_from_sensor, const LidarModel& model) {
  Scan scan;
  const int beams = std::max(model.beams, 0);
  scan.bearings_rad.reserve(static_cast<std::size_t>(beams));
  for (int beam = 0; beam < beams; ++beam) {
    scan.bearings_rad.push_back(model.start_angle_rad + beam * model.field_of_view_rad / beams);
  }
  scan.ranges_m.assign(scan.bearings_rad.size(), kNoHit);
  if (!map_from_sensor.isFinite() || !(model.range_max_m >= 0.0)) return scan;

  const MapFrame& frame = map.frame();
  const Eigen::Vector2d start_px = frame.pixelFromMetric(map_from_sensor.translation);
  if (stopsBeam(map.at(map_from_sensor.translation), model)) {
    std::fill(scan.ranges_m.begin(), scan.ranges_m.end(), 0.0);
    return scan;
  }
  const double heading_in_raster = map_from_sensor.heading - frame.metricFromCorner().heading;
  for (std::size_t beam = 0; beam < scan.ranges_m.size(); ++beam) {
    const double direction = heading_in_raster + scan.bearings_rad[beam];
    const Eigen::Vector2d px_per_m = Eigen::Vector2d(std::cos(direction), -std::sin(direction)) / frame.resolution();
    scan.ranges_m[beam] = castRay(map, start_px, px_per_m, model);
  }
  return scan;
}

}  // namespace cad2slam
