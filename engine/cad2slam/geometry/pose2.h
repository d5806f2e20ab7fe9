// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include <cmath>

#include "cad2slam/geometry/angle.h"

namespace cad2slam {

/// Counter-clockwise rotation of the plane.
inline Eigen::Matrix2d rotationMatrix(double heading_rad) {
  const double c = std::cos(heading_rad);
  const double s = std::sin(heading_rad);
  Eigen::Matrix2d rotation;
  rotation << c, -s, s, c;
  return rotation;
}

/// Rigid motion of the plane, an element of SE(2). A variable is named `target_from_source`:
///     p_in_target = target_from_source * p_in_source,    a_from_c = a_from_b * b_from_c
/// Metres; radians, counter-clockwise. The heading is stored as given, NOT wrapped.
struct Pose2 {
  Eigen::Vector2d translation = Eigen::Vector2d::Zero();  ///< [m]
  double heading = 0.0;                                   ///< [rad]

  [[nodiscard]] Eigen::Vector2d operator*(const Eigen::Vector2d& point) const {
    return rotationMatrix(heading) * point + translation;
  }
  [[nodiscard]] Pose2 operator*(const Pose2& other) const {
    return {*this * other.translation, heading + other.heading};
  }
  [[nodiscard]] Pose2 inverse() const { return {-(rotationMatrix(-heading) * translation), -heading}; }
  [[nodiscard]] double headingWrapped() const { return wrapAngle(heading); }  ///< [rad], in [-pi, pi)
  [[nodiscard]] bool isFinite() const { return translation.allFinite() && std::isfinite(heading); }
};

}  // namespace cad2slam
