// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include <vector>

#include "cad2slam/core/result.h"
#include "cad2slam/geometry/similarity_fit.h"

namespace cad2slam {

/// What people use today instead of a mesh, besides fitSimilarity().

struct Affine2 {
  Eigen::Matrix2d linear = Eigen::Matrix2d::Identity();
  Eigen::Vector2d translation = Eigen::Vector2d::Zero();  ///< [m] in the target frame

  [[nodiscard]] Eigen::Vector2d operator*(const Eigen::Vector2d& point) const { return linear * point + translation; }
};

/// Closed-form least squares over affine maps. kDegenerate: fewer than three pairs, or all sources on one line.
[[nodiscard]] Result<Affine2> fitAffine(const std::vector<PointPair>& pairs);

/// The interpolating thin-plate spline f(p) = A p + t + sum_i w_i U(|p - p_i|) with U(r) = r^2 log r: of all functions
/// that meet every pair exactly, the one with the least bending energy (Bookstein 1989).
class ThinPlateSpline {
 public:
  /// Pairs with the same source are replaced by their mean. kDegenerate as for fitAffine().
  [[nodiscard]] static Result<ThinPlateSpline> fit(const std::vector<PointPair>& pairs);

  [[nodiscard]] Eigen::Vector2d operator*(const Eigen::Vector2d& point) const;

 private:
  ThinPlateSpline() = default;

  // Sources are moved to their mean and scaled to unit size: U mixes lengths of very different powers.
  Eigen::Vector2d center_ = Eigen::Vector2d::Zero();
  double unit_ = 1.0;
  std::vector<Eigen::Vector2d> knots_;
  Eigen::Matrix<double, Eigen::Dynamic, 2> coefficients_;  ///< one row for each knot, then for 1, x, y
};

}  // namespace cad2slam
