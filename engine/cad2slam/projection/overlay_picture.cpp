// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/projection/overlay_picture.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "cad2slam/projection/raster_warper.h"

namespace cad2slam {
namespace {

constexpr auto kFree = static_cast<std::uint8_t>(CellState::kFree);
constexpr auto kOccupied = static_cast<std::uint8_t>(CellState::kOccupied);
constexpr auto kUnknown = static_cast<std::uint8_t>(CellState::kUnknown);

/// 255 where the state is seen, 0 elsewhere.
cv::Mat maskOf(const OccupancyGrid& grid, std::uint8_t state) {
  cv::Mat mask;
  cv::compare(grid.states(), cv::Scalar(state), mask, cv::CMP_EQ);
  return mask;
}

cv::Point2f toPixel(const MapFrame& frame, const Eigen::Vector2d& point_m) {
  const Eigen::Vector2d pixel = frame.pixelFromMetric(point_m);
  return {static_cast<float>(pixel.x()), static_cast<float>(pixel.y())};
}

void drawAnchors(const Projector& projector, const MapFrame& frame, const std::vector<OverlayAnchor>& anchors,
                 cv::Mat& picture) {
  const cv::Scalar ink(200, 110, 0);
  const int radius = std::max(4, std::max(picture.cols, picture.rows) / 250);
  for (const OverlayAnchor& anchor : anchors) {
    const cv::Point2f clicked = toPixel(frame, anchor.in_slam);
    const Projection there = projector.slamFromBlueprint({anchor.in_blueprint, 0.0}, OutsidePolicy::kRigid);
    if (there.ok()) cv::line(picture, clicked, toPixel(frame, there.pose.translation), ink, 2, cv::LINE_AA);
    cv::circle(picture, clicked, radius, cv::Scalar::all(255), 4, cv::LINE_AA);
    cv::circle(picture, clicked, radius, ink, 2, cv::LINE_AA);
  }
}

}  // namespace

Result<OccupancyGrid> warpGrid(const Projector& projector, bool to_slam, const OccupancyGrid& grid,
                               const MapFrame& target_frame) {
  const double scale = to_slam ? projector.info().scale : 1.0 / projector.info().scale;
  const double source_resolution = grid.frame().resolution() * scale;
  const int factor =
      static_cast<int>(std::clamp(std::ceil(target_frame.resolution() / source_resolution - 0.1), 1.0, 64.0));
  const Result<OccupancyGrid> source = pooled(grid, factor);
  if (!source) return failAs(source);
  WarpOptions options;
  options.smooth = false;
  options.outside_value = cv::Scalar::all(kUnknown);
  Result<cv::Mat> states = warpRaster(projector, to_slam ? WarpDirection::kToSlam : WarpDirection::kToBlueprint,
                                      source->states(), source->frame(), target_frame, options);
  if (!states) return failAs(states);
  return OccupancyGrid(target_frame, *states);
}

cv::Mat trinaryPicture(const OccupancyGrid& grid) {
  cv::Mat table(1, 256, CV_8UC1, cv::Scalar(205));
  table.at<std::uint8_t>(kFree) = 254;
  table.at<std::uint8_t>(kOccupied) = 0;
  cv::Mat picture;
  cv::LUT(grid.states(), table, picture);
  return picture;
}

Result<cv::Mat> drawOverlay(const Projector& projector, const OccupancyGrid& blueprint, const OccupancyGrid& slam,
                            const std::vector<OverlayAnchor>& anchors, int largest_side_px) {
  const int side = std::max(slam.frame().width(), slam.frame().height());
  const Result<OccupancyGrid> map = pooled(slam, (side + largest_side_px - 1) / std::max(1, largest_side_px));
  if (!map) return failAs(map);
  const Result<OccupancyGrid> warped = warpGrid(projector, true, blueprint, map->frame());
  if (!warped) return failAs(warped);
  const cv::Mat slam_walls = maskOf(*map, kOccupied);
  const cv::Mat blueprint_walls = maskOf(*warped, kOccupied);
  // Ink takes light away: magenta its green, green the red and the blue. Unknown is a light grey.
  cv::Mat channels[3];
  cv::Mat paper(slam_walls.size(), CV_8UC1, cv::Scalar(255));
  paper.setTo(cv::Scalar(226), maskOf(*map, kUnknown));
  cv::subtract(paper, 0.85 * slam_walls, channels[0]);
  cv::subtract(paper, 0.85 * blueprint_walls, channels[1]);
  channels[2] = channels[0].clone();
  cv::Mat picture;
  cv::merge(channels, 3, picture);
  drawAnchors(projector, map->frame(), anchors, picture);
  return picture;
}

}  // namespace cad2slam
