// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/solver/thin_plate_fit.h"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "cad2slam/solver/residual_scores.h"

namespace cad2slam {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;
using Rows2 = Eigen::Matrix<double, Eigen::Dynamic, 2>;

constexpr std::size_t kFewestPairs = 5;
constexpr double kNarrowest = 0.15;  // spread across the main direction, as a part of the spread along it

double radialBasis(double squared_distance) {
  return squared_distance > 0.0 ? 0.5 * squared_distance * std::log(squared_distance) : 0.0;
}

/// All splines of one set of weights, diagonal in lambda (Demmler and Reinsch): with the columns of Q orthogonal to the
/// affine functions, Q^T W^1/2 K W^1/2 Q = V diag(s) V^T and the bending coefficients are
/// c = W^1/2 Q V (diag(s) + lambda)^-1 (Q V)^T W^1/2 q.
class SplineFamily {
 public:
  SplineFamily(const MatrixXd& kernel, const MatrixXd& affine, const Rows2& targets, const std::vector<double>& weights)
      : root_weights_(Eigen::Map<const VectorXd>(weights.data(), kernel.rows()).cwiseSqrt()) {
    const Index n = kernel.rows();
    const Eigen::HouseholderQR<MatrixXd> qr(root_weights_.asDiagonal() * affine);
    const MatrixXd q = qr.householderQ() * MatrixXd::Identity(n, n);
    const auto bending = q.rightCols(n - affine.cols());
    const MatrixXd weighted = root_weights_.asDiagonal() * kernel * root_weights_.asDiagonal();
    const Eigen::SelfAdjointEigenSolver<MatrixXd> modes(bending.transpose() * weighted * bending);
    energies_ = modes.eigenvalues().cwiseMax(0.0);
    modes_ = bending * modes.eigenvectors();
    squared_modes_ = modes_.cwiseAbs2();
    targets_ = modes_.transpose() * (root_weights_.asDiagonal() * targets);
  }

  /// Row i: q_i - f_without_i(p_i), which is c_i / B_ii with B the matrix that takes q to c.
  [[nodiscard]] Rows2 leaveOneOut(double lambda) const {
    const VectorXd shrunk = (energies_.array() + lambda).inverse();
    const Rows2 coefficients = modes_ * (shrunk.asDiagonal() * targets_);
    const VectorXd diagonal = (squared_modes_ * shrunk).cwiseProduct(root_weights_);
    return diagonal.cwiseInverse().asDiagonal() * coefficients;
  }

 private:
  VectorXd root_weights_;
  VectorXd energies_;
  MatrixXd modes_;
  MatrixXd squared_modes_;
  Rows2 targets_;
};

double score(const Rows2& leave_one_out) {
  const VectorXd lengths = leave_one_out.rowwise().norm();
  return cappedMean({lengths.data(), lengths.data() + lengths.size()});
}

double bestLambda(const SplineFamily& family) {
  double best = 0.0;
  double best_score = std::numeric_limits<double>::infinity();
  for (const double lambda : {1.0, 0.3, 0.1, 0.03, 0.01, 3e-3, 1e-3, 3e-4, 1e-4, 1e-5, 1e-6}) {
    const double found = score(family.leaveOneOut(lambda));
    if (found >= best_score) continue;
    best = lambda;
    best_score = found;
  }
  return best;
}

bool spansPlane(const std::vector<Vector2d>& knots) {
  Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();
  for (const Vector2d& knot : knots) scatter += knot * knot.transpose();
  const Vector2d spread = Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(scatter).eigenvalues();
  return spread[0] > kNarrowest * kNarrowest * spread[1];
}

}  // namespace

Result<ThinPlateFit> ThinPlateFit::create(const std::vector<PointPair>& pairs, std::optional<double> loss_width_m,
                                          std::optional<double> lambda) {
  if (pairs.size() < kFewestPairs || pairs.size() > kMostPairs) {
    return fail(ErrorCode::kDegenerate, "a thin plate takes from " + std::to_string(kFewestPairs) + " to " +
                                            std::to_string(kMostPairs) + " anchors");
  }
  ThinPlateFit fit;
  const auto n = static_cast<Index>(pairs.size());
  for (const PointPair& pair : pairs) fit.center_ += pair.source / static_cast<double>(n);
  double squares = 0.0;
  for (const PointPair& pair : pairs) squares += (pair.source - fit.center_).squaredNorm();
  fit.unit_m_ = std::sqrt(squares / static_cast<double>(n));
  if (!(fit.unit_m_ > 0.0) || !std::isfinite(fit.unit_m_)) {
    return fail(ErrorCode::kDegenerate, "a thin plate needs anchors at different places");
  }
  for (const PointPair& pair : pairs) fit.knots_.push_back(fit.unitFrom(pair.source));
  if (!spansPlane(fit.knots_)) {
    return fail(ErrorCode::kDegenerate, "a thin plate needs anchors that are not close to one line");
  }

  MatrixXd kernel(n, n);
  MatrixXd affine(n, 3);
  Rows2 targets(n, 2);
  for (Index i = 0; i < n; ++i) {
    const VectorXd basis = fit.basisAt(pairs[static_cast<std::size_t>(i)].source);
    kernel.row(i) = basis.head(n).transpose();
    affine.row(i) = basis.tail<3>().transpose();
    targets.row(i) = pairs[static_cast<std::size_t>(i)].target.transpose();
  }

  // Weights from the leave-one-out residuals: a wrong anchor can pull the spline onto itself, but not its neighbours.
  fit.weights_.assign(pairs.size(), 1.0);
  Rows2 leave_one_out;
  constexpr int kPasses = 4;
  for (int pass = 0; pass < kPasses; ++pass) {
    const SplineFamily family(kernel, affine, targets, fit.weights_);
    fit.lambda_ = lambda ? *lambda : bestLambda(family);
    leave_one_out = family.leaveOneOut(fit.lambda_);
    if (!leave_one_out.allFinite()) return fail(ErrorCode::kDegenerate, "the thin plate has no finite solution");
    if (!loss_width_m || pass + 1 == kPasses) break;
    double change = 0.0;
    for (Index i = 0; i < n; ++i) {
      double& weight = fit.weights_[static_cast<std::size_t>(i)];
      const double loosened = 1.0 / (1.0 + leave_one_out.row(i).squaredNorm() / (*loss_width_m * *loss_width_m));
      change = std::max(change, std::abs(loosened - weight));
      weight = loosened;
    }
    constexpr double kWorthAnotherPass = 0.2;
    if (change < kWorthAnotherPass) break;
  }

  MatrixXd system = MatrixXd::Zero(n + 3, n + 3);
  system.topLeftCorner(n, n) = kernel;
  system.topRightCorner(n, 3) = affine;
  system.bottomLeftCorner(3, n) = affine.transpose();
  for (Index i = 0; i < n; ++i) system(i, i) += fit.lambda_ / fit.weights_[static_cast<std::size_t>(i)];
  fit.system_.compute(system);
  Rows2 right = Rows2::Zero(n + 3, 2);
  right.topRows(n) = targets;
  fit.coefficients_ = fit.system_.solve(right);
  if (!fit.coefficients_.allFinite()) return fail(ErrorCode::kDegenerate, "the thin plate has no finite solution");
  double whitened = 0.0;
  for (Index i = 0; i < n; ++i) {
    fit.leave_one_out_.emplace_back(-leave_one_out.row(i).transpose());
    // e_i has the variance 1 / B_ii, and c_i = B_ii e_i.
    whitened += leave_one_out.row(i).dot(fit.coefficients_.row(i));
  }
  fit.variance_factor_ = std::max(0.0, whitened) / (2.0 * static_cast<double>(n));
  return fit;
}

VectorXd ThinPlateFit::basisAt(const Vector2d& point) const {
  const Vector2d at = unitFrom(point);
  const auto n = static_cast<Index>(knots_.size());
  VectorXd basis(n + 3);
  for (Index i = 0; i < n; ++i) basis[i] = radialBasis((at - knots_[static_cast<std::size_t>(i)]).squaredNorm());
  basis.tail<3>() << 1.0, at.x(), at.y();
  return basis;
}

Vector2d ThinPlateFit::operator*(const Vector2d& point) const {
  return coefficients_.transpose() * basisAt(point);
}

Eigen::Matrix2d ThinPlateFit::jacobian(const Vector2d& point) const {
  const Vector2d at = unitFrom(point);
  const auto n = static_cast<Index>(knots_.size());
  Eigen::Matrix2d sum = coefficients_.bottomRows<2>().transpose();
  for (Index i = 0; i < n; ++i) {
    const Vector2d away = at - knots_[static_cast<std::size_t>(i)];
    const double squared = away.squaredNorm();
    if (squared == 0.0) continue;
    sum += (std::log(squared) + 1.0) * coefficients_.row(i).transpose() * away.transpose();
  }
  return sum / unit_m_;
}

double ThinPlateFit::sigma(const Vector2d& point) const {
  const VectorXd basis = basisAt(point);
  return std::sqrt(variance_factor_ * std::max(0.0, -basis.dot(system_.solve(basis))));
}

}  // namespace cad2slam
