// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

namespace cad2slam {

/// What one node predicts, as an affine function of the place in the blueprint: linear * p + offset.
struct NodePrediction {
  Eigen::Matrix2d linear;
  Eigen::Vector2d offset;
};

/// Weights of a quadratic B-spline at the three lattice centres around a place, and their derivatives.
struct SplineWeights {
  double value[3];
  double slope[3];

  explicit SplineWeights(double fraction)
      : value{0.5 * (1.0 - fraction) * (1.0 - fraction), 0.75 - (fraction - 0.5) * (fraction - 0.5),
              0.5 * fraction * fraction},
        slope{fraction - 1.0, 1.0 - 2.0 * fraction, fraction} {}
};

/// Weighted sums over the nodes around a place. Derivatives are with respect to the coordinate in which the weights
/// were given to add().
struct BlendSums {
  double weight = 0.0;
  Eigen::Vector2d weight_slope = Eigen::Vector2d::Zero();
  Eigen::Vector2d position = Eigen::Vector2d::Zero();
  Eigen::Matrix2d linear = Eigen::Matrix2d::Zero();
  Eigen::Matrix2d position_slope = Eigen::Matrix2d::Zero();

  void add(const NodePrediction& node, const Eigen::Vector2d& point, double w, double slope_x, double slope_y) {
    const Eigen::Vector2d predicted = node.linear * point + node.offset;
    weight += w;
    weight_slope.x() += slope_x;
    weight_slope.y() += slope_y;
    position += w * predicted;
    linear += w * node.linear;
    position_slope.col(0) += slope_x * predicted;
    position_slope.col(1) += slope_y * predicted;
  }
};

/// The forward function at one place.
struct Blend {
  Eigen::Vector2d position;  ///< [m], SLAM frame
  Eigen::Matrix2d linear;    ///< weighted mean of the nodes' linear parts: turns headings
  Eigen::Matrix2d jacobian;  ///< true derivative of the position
};

/// The blend that weighted sums stand for; `weights_from_point` is the derivative of the coordinates that weights were
/// given in by the place in the blueprint.
inline Blend blendOf(const BlendSums& sums, const Eigen::Matrix2d& weights_from_point) {
  const double inverse_weight = 1.0 / sums.weight;
  Blend blend;
  blend.position = sums.position * inverse_weight;
  blend.linear = sums.linear * inverse_weight;
  const Eigen::Matrix2d slope = (sums.position_slope - blend.position * sums.weight_slope.transpose()) * inverse_weight;
  blend.jacobian = blend.linear + slope * weights_from_point;
  return blend;
}

}  // namespace cad2slam
