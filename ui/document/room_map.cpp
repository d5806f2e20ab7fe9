// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/document/room_map.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>

namespace cad2slam {
namespace {

constexpr double kWorkingResolution = 0.1;  // [m/px]
constexpr double kHalfDoor = 0.6;           // [m] passages narrower than twice this separate rooms
constexpr double kSmallestRoom = 3.0;       // [m^2] after shrinking by half a door; less is a niche
constexpr double kAnchorReach = 1.5;        // [m] anchors sit on corners, so a little outside the shrunk room
constexpr int kLargestSide = 8000;          // [px] of the working picture

/// 255 where all of `factor` x `factor` pixels are free, 0 where none is.
cv::Mat freeShare(const OccupancyGrid& blueprint, int factor) {
  const int width = (blueprint.frame().width() + factor - 1) / factor;
  cv::Mat share;
  for (int top = 0; top < blueprint.frame().height(); top += factor) {
    const int rows = std::min(factor, blueprint.frame().height() - top);
    const cv::Mat states = blueprint.states({0, top, blueprint.frame().width(), rows});
    cv::Mat line = states == static_cast<int>(CellState::kFree);
    cv::resize(line, line, {width, 1}, 0.0, 0.0, cv::INTER_AREA);
    share.push_back(line);
  }
  return share;
}

}  // namespace

RoomMap RoomMap::find(const OccupancyGrid& blueprint) {
  const MapFrame& full = blueprint.frame();
  const double factor = std::max({1.0, kWorkingResolution / full.resolution(),
                                  static_cast<double>(std::max(full.width(), full.height())) / kLargestSide});
  const int width = std::max(1, static_cast<int>(full.width() / factor));
  const int height = std::max(1, static_cast<int>(full.height() / factor));
  cv::Mat is_free = freeShare(blueprint, static_cast<int>(factor));
  // Area means keep thin walls visible as a dip, and the threshold keeps them closed.
  cv::resize(is_free, is_free, {width, height}, 0.0, 0.0, cv::INTER_AREA);
  cv::threshold(is_free, is_free, 200, 255, cv::THRESH_BINARY);
  cv::copyMakeBorder(is_free, is_free, 1, 1, 1, 1, cv::BORDER_CONSTANT, cv::Scalar(0));

  const double resolution = full.resolution() * full.width() / width;
  const Result<MapFrame> frame = MapFrame::create(resolution, width, height, full.metricFromCorner());
  RoomMap map(frame ? *frame : full);
  cv::Mat clearance;
  cv::distanceTransform(is_free, clearance, cv::DIST_L2, cv::DIST_MASK_5);
  const cv::Rect inner(1, 1, width, height);
  const cv::Mat cores = clearance(inner) > kHalfDoor / resolution;
  cv::Mat labels;
  cv::Mat stats;
  cv::Mat centroids;
  const int count = cv::connectedComponentsWithStats(cores, labels, stats, centroids, 4, CV_32S);

  std::vector<int> room_of_label(static_cast<std::size_t>(count), 0);
  std::vector<float> best_clearance(static_cast<std::size_t>(count), -1.0F);
  std::vector<cv::Point> best_place(static_cast<std::size_t>(count));
  for (int row = 0; row < height; ++row) {
    const int* label = labels.ptr<int>(row);
    const float* clear = clearance.ptr<float>(row + 1) + 1;
    for (int column = 0; column < width; ++column) {
      const auto at = static_cast<std::size_t>(label[column]);
      if (at != 0 && clear[column] > best_clearance[at]) {
        best_clearance[at] = clear[column];
        best_place[at] = {column, row};
      }
    }
  }
  for (int label = 1; label < count; ++label) {
    const double area = stats.at<int>(label, cv::CC_STAT_AREA) * resolution * resolution;
    if (area < kSmallestRoom) continue;
    const cv::Point place = best_place[static_cast<std::size_t>(label)];
    map.rooms_.push_back({area, map.frame_.metricFromPixel({place.x + 0.5, place.y + 0.5})});
    room_of_label[static_cast<std::size_t>(label)] = static_cast<int>(map.rooms_.size());
  }
  labels.forEach<int>([&](int& label, const int*) { label = room_of_label[static_cast<std::size_t>(label)]; });
  map.labels_ = labels;
  return map;
}

std::optional<std::size_t> RoomMap::roomAt(const Eigen::Vector2d& point_m) const {
  const Eigen::Vector2d pixel = frame_.pixelFromMetric(point_m);
  if (!pixel.allFinite() || pixel.cwiseAbs().maxCoeff() > 1e6) return std::nullopt;
  const cv::Point center(static_cast<int>(std::floor(pixel.x())), static_cast<int>(std::floor(pixel.y())));
  const int reach = static_cast<int>(std::ceil(kAnchorReach / frame_.resolution()));
  const cv::Rect all(0, 0, labels_.cols, labels_.rows);
  const cv::Rect near = cv::Rect(center.x - reach, center.y - reach, 2 * reach + 1, 2 * reach + 1) & all;
  int nearest = 0;
  int nearest_distance = reach * reach + 1;
  for (int row = near.y; row < near.y + near.height; ++row) {
    for (int column = near.x; column < near.x + near.width; ++column) {
      const int label = labels_.at<int>(row, column);
      const int distance = (row - center.y) * (row - center.y) + (column - center.x) * (column - center.x);
      if (label != 0 && distance < nearest_distance) {
        nearest = label;
        nearest_distance = distance;
      }
    }
  }
  return nearest == 0 ? std::nullopt : std::optional(static_cast<std::size_t>(nearest - 1));
}

}  // namespace cad2slam
