// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/views/corner_finder.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <opencv2/imgproc.hpp>

namespace cad2slam {
namespace {

constexpr int kBlock = 3;   // pixels the structure tensor is summed over
constexpr int kMargin = 7;  // pixels around the searched disc, for gradients and refinement
constexpr double kLargestReach = 48;
// The smaller eigenvalue at a full-contrast right angle is about 1e-2 with this block; a fifth of the contrast is
// noise.
constexpr float kLeastEigenvalue = 4e-4F;

struct Corner {
  QPointF at_px;
  float strength = 0.0F;
};

std::optional<Corner> cornerAtLevel(RasterSource& raster, const QPointF& near_px, double reach_px, int level) {
  const double scale = 1.0 / (1 << level);
  const QPointF center = near_px * scale;
  const double reach = std::min(reach_px * scale, kLargestReach);
  const int half = static_cast<int>(std::ceil(reach)) + kMargin;
  const QRect window = QRect(static_cast<int>(std::floor(center.x())) - half,
                             static_cast<int>(std::floor(center.y())) - half, 2 * half + 1, 2 * half + 1) &
                       QRect(QPoint(0, 0), raster.levelSize(level));
  if (window.width() < 2 * kBlock || window.height() < 2 * kBlock) return std::nullopt;
  QImage pixels = raster.pixels(level, window);
  if (pixels.isNull()) return std::nullopt;
  if (pixels.format() != QImage::Format_Grayscale8) pixels = pixels.convertToFormat(QImage::Format_Grayscale8);
  const cv::Mat sharp(pixels.height(), pixels.width(), CV_8UC1, pixels.bits(),
                      static_cast<std::size_t>(pixels.bytesPerLine()));
  cv::Mat grey;  // the crossing of two lines of one pixel has four weak corners around it unless they are blurred
  cv::GaussianBlur(sharp, grey, cv::Size(5, 5), 1.0);

  cv::Mat strength;
  cv::cornerMinEigenVal(grey, strength, kBlock, 3);
  cv::Mat highest;
  cv::dilate(strength, highest, cv::Mat::ones(5, 5, CV_8U));

  std::vector<Corner> found;
  float strongest = 0.0F;
  for (int row = 1; row + 1 < strength.rows; ++row) {
    for (int column = 1; column + 1 < strength.cols; ++column) {
      const float value = strength.at<float>(row, column);
      if (value < kLeastEigenvalue || value < highest.at<float>(row, column)) continue;
      const QPointF at(window.x() + column + 0.5, window.y() + row + 0.5);
      const QPointF way = at - center;
      if (std::hypot(way.x(), way.y()) > reach) continue;
      strongest = std::max(strongest, value);
      found.push_back({at, value});
    }
  }
  std::optional<Corner> best;
  double best_distance = 0.0;
  for (const Corner& corner : found) {
    if (corner.strength < 0.4F * strongest) continue;
    const QPointF way = corner.at_px - center;
    const double distance = std::hypot(way.x(), way.y());
    if (best && distance >= best_distance) continue;
    best = corner;
    best_distance = distance;
  }
  if (!best) return std::nullopt;

  // OpenCV counts from the centre of the first pixel.
  const QPointF start = best->at_px - QPointF(window.x() + 0.5, window.y() + 0.5);
  std::vector<cv::Point2f> refined{{static_cast<float>(start.x()), static_cast<float>(start.y())}};
  constexpr int kRefine = 3;
  if (start.x() > kRefine + 1 && start.y() > kRefine + 1 && start.x() < grey.cols - kRefine - 2 &&
      start.y() < grey.rows - kRefine - 2) {
    cv::cornerSubPix(grey, refined, {kRefine, kRefine}, {-1, -1},
                     cv::TermCriteria(cv::TermCriteria::COUNT | cv::TermCriteria::EPS, 20, 0.01));
    const QPointF moved(refined[0].x - start.x(), refined[0].y - start.y());
    if (std::isfinite(moved.x()) && std::isfinite(moved.y()) && std::hypot(moved.x(), moved.y()) < 2.0) {
      best->at_px += moved;
    }
  }
  best->at_px /= scale;
  return best;
}

}  // namespace

std::optional<QPointF> findCorner(RasterSource& raster, const QPointF& near_px, double reach_px, int level) {
  if (raster.size().isEmpty() || !(reach_px > 0.0)) return std::nullopt;
  const QRectF raster_px =
      QRectF(QPointF(0, 0), QSizeF(raster.size())).adjusted(-reach_px, -reach_px, reach_px, reach_px);
  if (!raster_px.contains(near_px)) return std::nullopt;  // NaN is nowhere
  std::optional<Corner> corner = cornerAtLevel(raster, near_px, reach_px, level);
  if (!corner) return std::nullopt;
  for (int finer = level - 1; finer >= 0; --finer) {
    const std::optional<Corner> better = cornerAtLevel(raster, corner->at_px, 3.0 * (1 << finer), finer);
    if (!better) break;
    corner = better;
  }
  return corner->at_px;
}

}  // namespace cad2slam
