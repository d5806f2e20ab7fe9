// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include <cmath>

#include "cad2slam/geometry/pose2.h"

namespace cad2slam {

/// Rotation, uniform scale and translation of the plane: p_in_target = scale * R(heading) * p_in_source + translation.
struct Similarity2 {
  double scale = 1.0;                                     ///< target metres per source metre, > 0
  double heading = 0.0;                                   ///< [rad], counter-clockwise
  Eigen::Vector2d translation = Eigen::Vector2d::Zero();  ///< [m] in the target frame

  [[nodiscard]] Eigen::Vector2d operator*(const Eigen::Vector2d& point) const {
    return scale * (rotationMatrix(heading) * point) + translation;
  }
  [[nodiscard]] Pose2 operator*(const Pose2& pose) const { return {*this * pose.translation, heading + pose.heading}; }
  [[nodiscard]] Similarity2 inverse() const {
    return {1.0 / scale, -heading, -(rotationMatrix(-heading) * translation) / scale};
  }
};

}  // namespace cad2slam
