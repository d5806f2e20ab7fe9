// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/LU>

#include <optional>
#include <vector>

#include "cad2slam/core/result.h"
#include "cad2slam/geometry/similarity_fit.h"

namespace cad2slam {

/// The smoothing thin-plate spline f(p) = A p + t + sum_i c_i U(|p - p_i|), U(r) = r^2 log r, that minimises
/// sum_i w_i |f(p_i) - q_i|^2 + lambda x bending energy (Wahba, Spline Models for Observational Data, chapters 1, 2,
/// 4). lambda is the one with the smallest leave-one-out residuals; the weights w_i of pairs that contradict the others
/// fall as those of a Cauchy loss.
class ThinPlateFit {
 public:
  /// kDegenerate: fewer than five pairs, more than kMostPairs, or the sources lie close to one line, so that a plate
  /// through them says nothing of places beside it.
  /// `loss_width_m` as in SolverSettings; empty: squared loss. `lambda` empty: chosen.
  [[nodiscard]] static Result<ThinPlateFit> create(const std::vector<PointPair>& pairs,
                                                   std::optional<double> loss_width_m,
                                                   std::optional<double> lambda = {});
  static constexpr std::size_t kMostPairs = 600;  ///< the work grows with their cube

  [[nodiscard]] Eigen::Vector2d operator*(const Eigen::Vector2d& point) const { return at(point).place; }
  struct Linearisation {
    Eigen::Vector2d place;     ///< f(point)
    Eigen::Matrix2d jacobian;  ///< df / dpoint
  };
  [[nodiscard]] Linearisation at(const Eigen::Vector2d& point) const;

  /// For each pair f(p_i) - q_i of the spline of all other pairs, with the same lambda (closed form).
  [[nodiscard]] const std::vector<Eigen::Vector2d>& leaveOneOut() const { return leave_one_out_; }
  [[nodiscard]] double lambda() const { return lambda_; }  ///< in units of the scaled sources
  [[nodiscard]] const std::vector<double>& weights() const { return weights_; }

  /// Standard deviation [m] of f(point), a coordinate: the spline as a Gaussian process whose variance makes the
  /// leave-one-out residuals as large as they are.
  [[nodiscard]] double sigma(const Eigen::Vector2d& point) const;

 private:
  struct FromKnots;
  ThinPlateFit() = default;
  [[nodiscard]] Eigen::Vector2d unitFrom(const Eigen::Vector2d& point) const { return (point - center_) / unit_m_; }
  [[nodiscard]] FromKnots fromKnots(const Eigen::Vector2d& point) const;
  [[nodiscard]] Eigen::VectorXd basisAt(const Eigen::Vector2d& point) const;

  // Sources are moved to their mean and scaled to unit size: U mixes lengths of very different powers.
  Eigen::Vector2d center_ = Eigen::Vector2d::Zero();
  double unit_m_ = 1.0;
  Eigen::Array<double, Eigen::Dynamic, 2> knots_;
  Eigen::Matrix<double, Eigen::Dynamic, 2> coefficients_;  ///< one row for each knot, then for 1, x, y
  std::vector<Eigen::Vector2d> leave_one_out_;
  std::vector<double> weights_;
  double lambda_ = 0.0;
  Eigen::PartialPivLU<Eigen::MatrixXd> system_;
  double variance_factor_ = 0.0;
};

}  // namespace cad2slam
