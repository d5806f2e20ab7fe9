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

/// All splines of one set of weights. With the columns of Q orthogonal to the affine functions and
/// Q^T W^1/2 K W^1/2 Q = P T P^T, T tridiagonal, the bending coefficients are
/// c = W^1/2 Q P (T + lambda)^-1 (Q P)^T W^1/2 q, which takes the square of the number of pairs for each lambda.
class SplineFamily {
 public:
  SplineFamily(const MatrixXd& kernel, const MatrixXd& affine, const Rows2& targets, const std::vector<double>& weights)
      : root_weights_(Eigen::Map<const VectorXd>(weights.data(), kernel.rows()).cwiseSqrt()) {
    const Index bending = kernel.rows() - affine.cols();
    const Eigen::HouseholderQR<MatrixXd> qr(root_weights_.asDiagonal() * affine);
    MatrixXd turned = root_weights_.asDiagonal() * kernel * root_weights_.asDiagonal();
    turned.applyOnTheLeft(qr.householderQ().adjoint());
    turned.applyOnTheRight(qr.householderQ());
    const Eigen::Tridiagonalization<MatrixXd> tridiagonal(turned.bottomRightCorner(bending, bending));
    diagonal_ = tridiagonal.diagonal();
    beside_ = tridiagonal.subDiagonal();
    modes_ = MatrixXd::Zero(kernel.rows(), bending);
    modes_.bottomRows(bending) = tridiagonal.matrixQ();
    modes_.applyOnTheLeft(qr.householderQ());
    targets_ = modes_.transpose() * (root_weights_.asDiagonal() * targets);
  }

  /// Row i: q_i - f_without_i(p_i), which is c_i / B_ii with B the matrix that takes q to c.
  [[nodiscard]] Rows2 leaveOneOut(double lambda) const {
    // With T + lambda = L D L^T, B is the sum of m m^T / d over the columns m of Q P L^-T, times W^1/2 on both sides.
    Rows2 coefficients = Rows2::Zero(modes_.rows(), 2);
    VectorXd own = VectorXd::Zero(modes_.rows());
    VectorXd mode = VectorXd::Zero(modes_.rows());
    Eigen::RowVector2d target = Eigen::RowVector2d::Zero();
    double pivot = 1.0;
    for (Index k = 0; k < modes_.cols(); ++k) {
      const double lower = k > 0 ? beside_[k - 1] / pivot : 0.0;
      pivot = diagonal_[k] + lambda - (k > 0 ? lower * beside_[k - 1] : 0.0);
      mode = modes_.col(k) - lower * mode;
      target = targets_.row(k) - lower * target;
      own += mode.cwiseAbs2() / pivot;
      coefficients.noalias() += mode * (target / pivot);
    }
    return own.cwiseProduct(root_weights_).cwiseInverse().asDiagonal() * coefficients;
  }

 private:
  VectorXd root_weights_;
  VectorXd diagonal_;  // of T
  VectorXd beside_;
  MatrixXd modes_;  // Q P
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

bool spansPlane(const Rows2& knots) {
  const Eigen::Matrix2d scatter = knots.transpose() * knots;
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
  fit.knots_.resize(n, 2);
  for (Index i = 0; i < n; ++i) fit.knots_.row(i) = fit.unitFrom(pairs[static_cast<std::size_t>(i)].source).transpose();
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

/// From each knot to a point, in units.
struct ThinPlateFit::FromKnots {
  Vector2d at;
  Eigen::ArrayX2d away;
  Eigen::ArrayXd squared;    // distance
  Eigen::ArrayXd logarithm;  // of the square; finite at a knot, where all that it is multiplied with is zero
};

ThinPlateFit::FromKnots ThinPlateFit::fromKnots(const Vector2d& point) const {
  FromKnots from;
  from.at = unitFrom(point);
  from.away = (-knots_).rowwise() + from.at.transpose().array();
  from.squared = from.away.col(0).square() + from.away.col(1).square();
  // The C library's is twice as fast as Eigen's without AVX.
  from.logarithm = from.squared.max(std::numeric_limits<double>::min()).unaryExpr([](double x) { return std::log(x); });
  return from;
}

VectorXd ThinPlateFit::basisAt(const Vector2d& point) const {
  const FromKnots from = fromKnots(point);
  VectorXd basis(knots_.rows() + 3);
  basis << 0.5 * from.squared * from.logarithm, 1.0, from.at;
  return basis;
}

ThinPlateFit::Linearisation ThinPlateFit::at(const Vector2d& point) const {
  const FromKnots from = fromKnots(point);
  const Index n = knots_.rows();
  Eigen::Matrix<double, Eigen::Dynamic, 3> derivatives(n, 3);  // of U: none, by x, by y
  derivatives << 0.5 * from.squared * from.logarithm, from.away.colwise() * (from.logarithm + 1.0);
  Eigen::Matrix<double, 2, 3> sums = coefficients_.topRows(n).transpose() * derivatives;
  sums.col(0) += coefficients_.bottomRows<3>().transpose() * Eigen::Vector3d(1.0, from.at.x(), from.at.y());
  sums.rightCols<2>() += coefficients_.bottomRows<2>().transpose();
  return {sums.col(0), sums.rightCols<2>() / unit_m_};
}

double ThinPlateFit::sigma(const Vector2d& point) const {
  const VectorXd basis = basisAt(point);
  return std::sqrt(variance_factor_ * std::max(0.0, -basis.dot(system_.solve(basis))));
}

}  // namespace cad2slam
