// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "slam_mapper.h"

#include "cad2slam/map/grid_traversal.h"
#include "cad2slam/simulation/lidar_simulator.h"

#include <opencv2/core.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace cad2slam::samples {
namespace {

constexpr float kHit = 0.9F;
constexpr float kMiss = -0.35F;
constexpr float kSure = 4.0F;
constexpr float kOccupiedAbove = 0.6F;
constexpr float kFreeBelow = -0.6F;
constexpr double kLegRadius = 0.12;

/// The warp, tabulated: a sweep asks for it millions of times.
class WarpTable {
 public:
  WarpTable(const WarpField& warp, const SitePlan& plan) {
    const Eigen::Vector2d size = (plan.size_m - 2.0 * first_) / kStep;
    columns_ = static_cast<int>(std::ceil(size.x())) + 1;
    rows_ = static_cast<int>(std::ceil(size.y())) + 1;
    for (int row = 0; row < rows_; ++row) {
      for (int column = 0; column < columns_; ++column) {
        places_.push_back(warp.slamFromPlan(Eigen::Vector2d(first_ + kStep * Eigen::Vector2d(column, row))));
      }
    }
  }

  [[nodiscard]] Eigen::Vector2d operator()(const Eigen::Vector2d& point_in_plan) const {
    const Eigen::Vector2d at = (point_in_plan - first_) / kStep;
    const int column = std::clamp(static_cast<int>(std::floor(at.x())), 0, columns_ - 2);
    const int row = std::clamp(static_cast<int>(std::floor(at.y())), 0, rows_ - 2);
    const double right = at.x() - column;
    const double up = at.y() - row;
    const Eigen::Vector2d* low = &places_[static_cast<std::size_t>(row) * columns_ + column];
    const Eigen::Vector2d* high = low + columns_;
    return (1.0 - up) * ((1.0 - right) * low[0] + right * low[1]) + up * ((1.0 - right) * high[0] + right * high[1]);
  }
  [[nodiscard]] const std::vector<Eigen::Vector2d>& places() const { return places_; }

 private:
  static constexpr double kStep = 0.25;
  Eigen::Vector2d first_{-1.0, -1.0};
  int columns_ = 0;
  int rows_ = 0;
  std::vector<Eigen::Vector2d> places_;
};

MapFrame frameAround(const std::vector<Eigen::Vector2d>& places, double resolution) {
  Eigen::Vector2d low = places.front();
  Eigen::Vector2d high = low;
  for (const Eigen::Vector2d& place : places) {
    low = low.cwiseMin(place);
    high = high.cwiseMax(place);
  }
  // Like a SLAM program that grows its map in whole cells around the place where it started.
  const Eigen::Vector2d cells = ((low.array() - 0.5) / resolution).floor();
  const Eigen::Vector2d corner = (cells * resolution * 1e6).array().round() / 1e6;  // short numbers in the YAML
  const Eigen::Vector2d size_px = ((high - corner).array() + 0.5) / resolution;
  return *MapFrame::create(resolution, static_cast<int>(std::ceil(size_px.x())),
                           static_cast<int>(std::ceil(size_px.y())), {corner, 0.0});
}

class Mapper {
 public:
  Mapper(const MapFrame& frame, const WarpTable& warp)
      : frame_(frame), warp_(warp), log_odds_(frame.height(), frame.width(), CV_32FC1, cv::Scalar(0)) {}

  void enterBeam(const Eigen::Vector2d& sensor, const Eigen::Vector2d& hit) {
    // A straight beam is bent in the SLAM map: it is entered in pieces.
    constexpr double kPiece = 1.0;
    const int pieces = std::max(1, static_cast<int>(std::ceil((hit - sensor).norm() / kPiece)));
    Eigen::Vector2d from = frame_.pixelFromMetric(warp_(sensor));
    const Eigen::Vector2d end = frame_.pixelFromMetric(warp_(hit));
    for (int piece = 1; piece <= pieces; ++piece) {
      const Eigen::Vector2d to =
          frame_.pixelFromMetric(warp_(sensor + (hit - sensor) * (static_cast<double>(piece) / pieces)));
      for (GridTraversal ray(from, to - from); ray.entered() < 1.0 && isInside(ray.column(), ray.row());
           ray.advance()) {
        if (ray.column() == static_cast<int>(end.x()) && ray.row() == static_cast<int>(end.y())) break;
        add(ray.column(), ray.row(), kMiss);
      }
      from = to;
    }
    if (isInside(static_cast<int>(end.x()), static_cast<int>(end.y()))) {
      add(static_cast<int>(end.x()), static_cast<int>(end.y()), kHit);
    }
  }

  [[nodiscard]] cv::Mat picture() const {
    cv::Mat grey(log_odds_.size(), CV_8UC1, cv::Scalar(205));
    grey.setTo(254, log_odds_ < kFreeBelow);
    grey.setTo(0, log_odds_ > kOccupiedAbove);
    return grey;
  }

 private:
  [[nodiscard]] bool isInside(int column, int row) const {
    return column >= 0 && row >= 0 && column < log_odds_.cols && row < log_odds_.rows;
  }
  void add(int column, int row, float evidence) {
    float& cell = log_odds_.at<float>(row, column);
    cell = std::clamp(cell + evidence, -kSure, kSure);
  }

  const MapFrame& frame_;
  const WarpTable& warp_;
  cv::Mat log_odds_;
};

/// Way from `from` along a unit direction to a disc; infinite when it is missed.
double rangeToDisc(const Eigen::Vector2d& from, const Eigen::Vector2d& unit, const Eigen::Vector2d& center) {
  const Eigen::Vector2d offset = center - from;
  const double along = offset.dot(unit);
  const double off_axis = offset.squaredNorm() - along * along;
  const double reach = kLegRadius * kLegRadius - off_axis;
  if (along <= 0.0 || reach < 0.0) return std::numeric_limits<double>::infinity();
  return along - std::sqrt(reach);
}

}  // namespace

Result<SlamMap> mapDrive(const SitePlan& plan, const FurnishedWorld& world, const std::vector<Pose2>& drive,
                         const WarpField& warp, const SensorModel& sensor, double resolution_m_per_px,
                         SeededRandom& random) {
  if (drive.empty()) return fail(ErrorCode::kDegenerate, "The robot cannot move in this building");
  const WarpTable table(warp, plan);
  const MapFrame frame = frameAround(table.places(), resolution_m_per_px);
  Mapper mapper(frame, table);
  LidarModel model;
  model.beams = sensor.beams;
  model.range_max_m = sensor.range_max_m;
  for (std::size_t i = 0; i < drive.size(); ++i) {
    // People walk on the robot's own way, most of them towards it.
    std::vector<Eigen::Vector2d> legs;
    for (int person = 0; person < sensor.people; ++person) {
      const std::size_t step =
          (drive.size() * static_cast<std::size_t>(person + 1) / 3 + 3 * drive.size() - i) % drive.size();
      const Pose2& walker = drive[step];
      if ((walker.translation - drive[i].translation).norm() < 0.8) continue;
      const double stride = 0.15 * std::sin(0.9 * static_cast<double>(i));
      legs.push_back(walker * Eigen::Vector2d(stride, 0.45));
      legs.push_back(walker * Eigen::Vector2d(-stride, 0.7));
    }
    const Pose2 pose{drive[i].translation, random.uniform(-kPi, kPi)};  // beams fall between those of the scan before
    const Scan scan = simulateScan(world.grid, pose, model);
    for (std::size_t beam = 0; beam < scan.ranges_m.size(); ++beam) {
      const double bearing = pose.heading + scan.bearings_rad[beam];
      const Eigen::Vector2d unit(std::cos(bearing), std::sin(bearing));
      double range = scan.ranges_m[beam];
      for (const Eigen::Vector2d& leg : legs) range = std::min(range, rangeToDisc(pose.translation, unit, leg));
      if (!std::isfinite(range) || range > sensor.range_max_m || random.chance(sensor.dropout)) continue;
      const double measured = std::max(0.05, range + sensor.noise_m * random.normal());
      mapper.enterBeam(pose.translation, pose.translation + measured * unit);
    }
  }
  return SlamMap{frame, mapper.picture()};
}

}  // namespace cad2slam::samples
