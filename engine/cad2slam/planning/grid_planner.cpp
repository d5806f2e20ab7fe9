// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/planning/grid_planner.h"

#include "cad2slam/map/grid_traversal.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <queue>

namespace cad2slam {
namespace {

constexpr double kMaxPoses = 1e7;
constexpr double kMostPixels = 25e6;  // the search takes ten bytes a pixel; larger maps are made coarser
constexpr std::uint8_t kNoParent = 0xff;
constexpr std::array<std::array<int, 2>, 8> kSteps = {
    {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {1, -1}, {-1, 1}, {-1, -1}}};

std::string describe(const Eigen::Vector2d& point_m) {
  std::array<char, 80> text{};
  std::snprintf(text.data(), text.size(), "(%.2f, %.2f)", point_m.x(), point_m.y());
  return text.data();
}

/// Cost of a metre in each pixel: 1 far from walls, infinite where the robot does not fit.
class CostField {
 public:
  CostField(const OccupancyGrid& map, const PlannerSettings& settings) : resolution_(map.frame().resolution()) {
    // One closed pixel all around stands for the outside, which is unknown.
    const cv::Mat states = map.states();
    const cv::Rect inner(1, 1, states.cols, states.rows);
    cv::Mat open(states.rows + 2, states.cols + 2, CV_8UC1, cv::Scalar(0));
    cv::compare(states, static_cast<int>(CellState::kFree), open(inner), cv::CMP_EQ);
    cv::Mat distance_px;
    cv::distanceTransform(open, distance_px, cv::DIST_L2, cv::DIST_MASK_PRECISE);
    cost_ = distance_px(inner).clone();
    for (int row = 0; row < cost_.rows; ++row) {
      float* cost = cost_.ptr<float>(row);
      for (int column = 0; column < cost_.cols; ++column) cost[column] = costAt(cost[column], settings);
    }
  }

  [[nodiscard]] int width() const { return cost_.cols; }
  [[nodiscard]] int height() const { return cost_.rows; }
  [[nodiscard]] double resolution() const { return resolution_; }
  [[nodiscard]] bool contains(int column, int row) const {
    return column >= 0 && row >= 0 && column < cost_.cols && row < cost_.rows;
  }
  /// Per metre; infinite on closed pixels and outside.
  [[nodiscard]] float at(int column, int row) const {
    return contains(column, row) ? cost_.ptr<float>(row)[column] : kClosed;
  }
  [[nodiscard]] bool isOpen(int column, int row) const { return at(column, row) < kClosed; }

  /// Cost [m] of a straight way between two points of the pixel frame; infinite where it touches a closed pixel.
  [[nodiscard]] double ofSegment(const Eigen::Vector2d& from_px, const Eigen::Vector2d& to_px) const {
    const double length_m = (to_px - from_px).norm() * resolution_;
    double cost = 0.0;
    for (GridTraversal ray(from_px, to_px - from_px);; ray.advance()) {
      const float per_m = at(ray.column(), ray.row());
      if (per_m == kClosed) return kClosed;
      const double leaves = std::min(ray.leaves(), 1.0);
      cost += (leaves - ray.entered()) * length_m * per_m;
      if (leaves >= 1.0) return cost;
      if (ray.leavesThroughCorner() && !isOpen(ray.column() + ray.columnStep(), ray.row())) return kClosed;
    }
  }

 private:
  static constexpr float kClosed = std::numeric_limits<float>::infinity();

  [[nodiscard]] float costAt(float distance_px, const PlannerSettings& settings) const {
    const double distance_m = distance_px * resolution_;
    if (distance_px == 0.0F || distance_m < settings.robot_radius_m) return kClosed;
    if (distance_m >= settings.wanted_clearance_m) return 1.0F;
    return static_cast<float>(1.0 + settings.clearance_cost * (1.0 - distance_m / settings.wanted_clearance_m));
  }

  double resolution_;
  cv::Mat cost_;
};

struct GridWay {
  std::vector<cv::Point> pixels;  ///< start to goal, both included
  double cost_m = 0.0;
};

class GridSearch {
 public:
  GridSearch(const CostField& field, cv::Point start, cv::Point goal) : field_(field), start_(start), goal_(goal) {}

  /// A* over the 8-connected grid; empty when the goal cannot be reached.
  [[nodiscard]] GridWay run() {
    best_ = cv::Mat(field_.height(), field_.width(), CV_32FC1, cv::Scalar(std::numeric_limits<float>::infinity()));
    parent_ = cv::Mat(field_.height(), field_.width(), CV_8UC1, cv::Scalar(kNoParent));
    best_.at<float>(start_) = 0.0F;
    queue_.push({static_cast<float>(octile(start_)), 0.0F, start_});
    while (!queue_.empty()) {
      const Entry entry = queue_.top();
      queue_.pop();
      if (entry.cost > best_.at<float>(entry.pixel)) continue;  // a cheaper way to it was expanded before
      if (entry.pixel == goal_) return trace(entry.cost);
      expand(entry);
    }
    return {};
  }

 private:
  struct Entry {
    float estimate;
    float cost;
    cv::Point pixel;
    bool operator<(const Entry& other) const {  // std::priority_queue pops the largest
      return estimate != other.estimate ? estimate > other.estimate : cost < other.cost;
    }
  };

  /// Length [px] of the way to the goal on an empty grid: never more than the real cost, as no pixel costs less than 1.
  [[nodiscard]] double octile(cv::Point from) const {
    const int columns = std::abs(from.x - goal_.x);
    const int rows = std::abs(from.y - goal_.y);
    return std::max(columns, rows) + (std::sqrt(2.0) - 1.0) * std::min(columns, rows);
  }

  void expand(const Entry& entry) {
    const float here = field_.at(entry.pixel.x, entry.pixel.y);
    for (std::uint8_t step = 0; step < kSteps.size(); ++step) {
      const cv::Point next(entry.pixel.x + kSteps[step][0], entry.pixel.y + kSteps[step][1]);
      if (!field_.isOpen(next.x, next.y)) continue;
      const bool diagonal = step >= 4;
      if (diagonal && !(field_.isOpen(next.x, entry.pixel.y) && field_.isOpen(entry.pixel.x, next.y))) continue;
      const float length = diagonal ? std::sqrt(2.0F) : 1.0F;
      const float cost = entry.cost + length * 0.5F * (here + field_.at(next.x, next.y));
      if (cost >= best_.at<float>(next)) continue;
      best_.at<float>(next) = cost;
      parent_.at<std::uint8_t>(next) = step;
      queue_.push({cost + static_cast<float>(octile(next)), cost, next});
    }
  }

  [[nodiscard]] GridWay trace(float cost_px) const {
    GridWay way;
    way.cost_m = static_cast<double>(cost_px) * field_.resolution();
    for (cv::Point pixel = goal_;;) {
      way.pixels.push_back(pixel);
      if (pixel == start_) break;
      const auto& step = kSteps[parent_.at<std::uint8_t>(pixel)];
      pixel -= cv::Point(step[0], step[1]);
    }
    std::reverse(way.pixels.begin(), way.pixels.end());
    return way;
  }

  const CostField& field_;
  cv::Point start_;
  cv::Point goal_;
  cv::Mat best_;    ///< cost [px] of the best way found so far
  cv::Mat parent_;  ///< index into kSteps of the last step of that way
  std::priority_queue<Entry> queue_;
};

using Polyline = std::vector<Eigen::Vector2d>;  // pixel frame

/// Leaves out points while the straight way instead is open and not dearer. One pass from the start, linear in time:
/// each straight way is prolonged as far as it goes.
Polyline shortenGreedily(const CostField& field, const Polyline& points) {
  Polyline kept = {points.front()};
  std::size_t last = 0;
  while (last + 1 < points.size()) {
    std::size_t next = last + 1;
    double cost_along = field.ofSegment(points[last], points[next]);
    for (std::size_t candidate = next + 1; candidate < points.size(); ++candidate) {
      cost_along += field.ofSegment(points[candidate - 1], points[candidate]);
      const double direct = field.ofSegment(points[last], points[candidate]);
      if (!(direct <= cost_along * (1.0 + 1e-9))) break;
      next = candidate;
    }
    kept.push_back(points[next]);
    last = next;
  }
  return kept;
}

/// The cheapest way that uses any of the points in their order.
Polyline shortenExhaustively(const CostField& field, const Polyline& points) {
  std::vector<double> cost(points.size(), std::numeric_limits<double>::infinity());
  std::vector<std::size_t> previous(points.size(), 0);
  cost[0] = 0.0;
  for (std::size_t to = 1; to < points.size(); ++to) {
    for (std::size_t from = 0; from < to; ++from) {
      const double lower_bound = cost[from] + (points[to] - points[from]).norm() * field.resolution();
      if (lower_bound >= cost[to]) continue;
      const double candidate = cost[from] + field.ofSegment(points[from], points[to]);
      if (candidate < cost[to]) {
        cost[to] = candidate;
        previous[to] = from;
      }
    }
  }
  Polyline kept;
  for (std::size_t at = points.size() - 1; at != 0; at = previous[at]) kept.push_back(points[at]);
  kept.push_back(points.front());
  std::reverse(kept.begin(), kept.end());
  return kept;
}

Polyline shorten(const CostField& field, const Polyline& points) {
  constexpr std::size_t kFewPoints = 400;  // quadratic below this
  const Polyline fewer = shortenGreedily(field, points);
  return fewer.size() <= kFewPoints ? shortenExhaustively(field, fewer) : fewer;
}

Result<PlannedPath> sample(const Polyline& corners_m, double step_m) {
  PlannedPath path;
  for (std::size_t i = 1; i < corners_m.size(); ++i) path.length_m += (corners_m[i] - corners_m[i - 1]).norm();
  if (path.length_m == 0.0) {
    path.poses.push_back({corners_m.front(), 0.0});
    return path;
  }
  const double intervals = std::ceil(path.length_m / step_m);
  if (!(intervals <= kMaxPoses)) {
    return fail(ErrorCode::kOutOfDomain, "The step between two poses of the path is too small for its length");
  }
  const auto count = static_cast<std::size_t>(intervals);
  std::size_t segment = 1;
  double before_segment_m = 0.0;
  for (std::size_t i = 0; i <= count; ++i) {
    const double along_m = path.length_m * static_cast<double>(i) / static_cast<double>(count);
    double segment_m = (corners_m[segment] - corners_m[segment - 1]).norm();
    while (segment + 1 < corners_m.size() && before_segment_m + segment_m < along_m) {
      before_segment_m += segment_m;
      ++segment;
      segment_m = (corners_m[segment] - corners_m[segment - 1]).norm();
    }
    const Eigen::Vector2d direction = corners_m[segment] - corners_m[segment - 1];
    const double part = segment_m > 0.0 ? std::min(1.0, (along_m - before_segment_m) / segment_m) : 1.0;
    path.poses.push_back({corners_m[segment - 1] + part * direction, std::atan2(direction.y(), direction.x())});
  }
  path.poses.back().translation = corners_m.back();
  return path;
}

/// `field_frame`: of the field, which may be coarser than the map.
Result<cv::Point> openPixel(const OccupancyGrid& map, const CostField& field, const MapFrame& field_frame,
                            const Eigen::Vector2d& point_m, const std::string& role) {
  if (!point_m.allFinite() || !map.frame().contains(point_m)) {
    return fail(ErrorCode::kOutOfDomain, "The " + role + " " + describe(point_m) + " lies outside of the map");
  }
  switch (map.at(point_m)) {
    case CellState::kOccupied:
      return fail(ErrorCode::kOutOfDomain, "The " + role + " " + describe(point_m) + " lies inside a wall");
    case CellState::kUnknown:
      return fail(ErrorCode::kOutOfDomain, "The " + role + " " + describe(point_m) + " lies where the map is unknown");
    case CellState::kFree:
      break;
  }
  const Eigen::Vector2d pixel = field_frame.pixelFromMetric(point_m);
  const cv::Point cell(static_cast<int>(std::floor(pixel.x())), static_cast<int>(std::floor(pixel.y())));
  if (!field.isOpen(cell.x, cell.y)) {
    return fail(ErrorCode::kOutOfDomain,
                "The " + role + " " + describe(point_m) + " lies nearer to a wall than the radius of the robot");
  }
  return cell;
}

bool isLength(double value) {
  return std::isfinite(value) && value >= 0.0;
}

}  // namespace

Result<PlannedPath> planPath(const OccupancyGrid& map, const Eigen::Vector2d& start_m, const Eigen::Vector2d& goal_m,
                             const PlannerSettings& settings) {
  if (!isLength(settings.robot_radius_m) || !isLength(settings.wanted_clearance_m) ||
      !isLength(settings.clearance_cost) || !isLength(settings.step_m) || settings.step_m == 0.0) {
    return fail(ErrorCode::kOutOfDomain,
                "The planner needs a positive step, and a radius, clearance and clearance cost that are not negative");
  }
  const double pixels = static_cast<double>(map.frame().width()) * map.frame().height();
  const Result<OccupancyGrid> grid = pooled(map, static_cast<int>(std::ceil(std::sqrt(pixels / kMostPixels))));
  if (!grid) return failAs(grid);
  const MapFrame& frame = grid->frame();
  const CostField field(*grid, settings);
  const Result<cv::Point> start = openPixel(map, field, frame, start_m, "start");
  if (!start) return failAs(start);
  const Result<cv::Point> goal = openPixel(map, field, frame, goal_m, "goal");
  if (!goal) return failAs(goal);

  const GridWay way = GridSearch(field, *start, *goal).run();
  if (way.pixels.empty()) {
    return fail(ErrorCode::kDegenerate, "No path leads from " + describe(start_m) + " to " + describe(goal_m));
  }
  Polyline points = {frame.pixelFromMetric(start_m)};
  for (const cv::Point& pixel : way.pixels) points.emplace_back(pixel.x + 0.5, pixel.y + 0.5);
  points.push_back(frame.pixelFromMetric(goal_m));

  Polyline corners_m;
  for (const Eigen::Vector2d& point : shorten(field, points)) {
    const Eigen::Vector2d corner = frame.metricFromPixel(point);
    if (corners_m.empty() || corner != corners_m.back()) corners_m.push_back(corner);
  }
  corners_m.front() = start_m;
  corners_m.back() = goal_m;
  Result<PlannedPath> path = sample(corners_m, settings.step_m);
  if (path) path->grid_cost_m = way.cost_m;
  return path;
}

}  // namespace cad2slam
