// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include <opencv2/imgproc.hpp>

#include "cad2slam/map/map_frame.h"
#include "ui/services/tile_pyramid.h"

namespace cad2slam::test {

/// White floor with black walls: rooms of 100 x 80 pixels, walls 4 pixels thick, corners at known places.
inline cv::Mat floorPlan(int width, int height) {
  cv::Mat plan(height, width, CV_8UC1, cv::Scalar(255));
  for (int x = 0; x < width; x += 100) plan.colRange(x, std::min(width, x + 4)).setTo(0);
  for (int y = 0; y < height; y += 80) plan.rowRange(y, std::min(height, y + 4)).setTo(0);
  for (int x = 0; x < width; x += 100) {
    for (int y = 30; y < height; y += 80) {  // doors
      plan(cv::Rect(x, y, 4, 24) & cv::Rect(0, 0, width, height)).setTo(255);
    }
  }
  return plan;
}

inline MapFrame frameOf(const cv::Mat& pixels, double resolution, const Pose2& metric_from_corner = {}) {
  return *MapFrame::create(resolution, pixels.cols, pixels.rows, metric_from_corner);
}

}  // namespace cad2slam::test
