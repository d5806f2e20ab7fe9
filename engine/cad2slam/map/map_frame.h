// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "cad2slam/core/result.h"
#include "cad2slam/geometry/pose2.h"

namespace cad2slam {

/// Ties the pixel grid of one raster to its metric frame, with map_server conventions.
/// pixel frame: (column, row), continuous; (0, 0) is the OUTER top-left corner; row grows down; the centre of the pixel
///   in column c and row r is (c + 0.5, r + 0.5).
/// metric frame: metres, x right, y up; `metric_from_corner` is the pose of the outer bottom-left corner of the image
///   (`origin:` in the YAML), so the raster may be turned inside its metric frame.
class MapFrame {
 public:
  /// kMalformed unless the resolution is finite and > 0, both sizes are > 0 and the pose is finite.
  [[nodiscard]] static Result<MapFrame> create(double resolution_m_per_px, int width_px, int height_px,
                                               const Pose2& metric_from_corner);

  [[nodiscard]] double resolution() const { return resolution_; }  ///< [m/px]
  [[nodiscard]] int width() const { return width_; }               ///< [px]
  [[nodiscard]] int height() const { return height_; }             ///< [px]
  [[nodiscard]] const Pose2& metricFromCorner() const { return metric_from_corner_; }
  [[nodiscard]] double diagonal() const { return resolution_ * std::hypot(width_, height_); }  ///< [m]

  [[nodiscard]] Eigen::Vector2d metricFromPixel(const Eigen::Vector2d& pixel) const {
    return metric_from_corner_.translation +
           rotation_ * Eigen::Vector2d(pixel.x() * resolution_, (height_ - pixel.y()) * resolution_);
  }
  [[nodiscard]] Eigen::Vector2d pixelFromMetric(const Eigen::Vector2d& point_m) const {
    const Eigen::Vector2d corner = rotation_.transpose() * (point_m - metric_from_corner_.translation);
    return {corner.x() / resolution_, height_ - corner.y() / resolution_};
  }
  /// Half-open in the pixel frame: the left and top edges are inside, the right and bottom edges are not.
  [[nodiscard]] bool contains(const Eigen::Vector2d& point_m) const {
    const Eigen::Vector2d pixel = pixelFromMetric(point_m);
    return pixel.x() >= 0.0 && pixel.y() >= 0.0 && pixel.x() < width_ && pixel.y() < height_;
  }

 private:
  MapFrame(double resolution, int width, int height, const Pose2& metric_from_corner)
      : resolution_(resolution),
        width_(width),
        height_(height),
        metric_from_corner_(metric_from_corner),
        rotation_(rotationMatrix(metric_from_corner.heading)) {}

  double resolution_;
  int width_;
  int height_;
  Pose2 metric_from_corner_;
  Eigen::Matrix2d rotation_;
};

}  // namespace cad2slam
