// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/evaluation/baselines.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace cad2slam {
namespace {

constexpr double kFlat = 1e-6;  // spread across the main direction, as a part of the spread along it

Eigen::Vector2d meanSource(const std::vector<PointPair>& pairs) {
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const PointPair& pair : pairs) mean += pair.source / static_cast<double>(pairs.size());
  return mean;
}

/// Whether the sources span the plane.
bool spansPlane(const std::vector<PointPair>& pairs) {
  if (pairs.size() < 3) return false;
  const Eigen::Vector2d mean = meanSource(pairs);
  Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();
  for (const PointPair& pair : pairs) scatter += (pair.source - mean) * (pair.source - mean).transpose();
  const Eigen::Vector2d spread = Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(scatter).eigenvalues();
  return std::isfinite(spread[1]) && spread[0] > kFlat * kFlat * spread[1];
}

double radialBasis(double squared_distance) {
  return squared_distance > 0.0 ? 0.5 * squared_distance * std::log(squared_distance) : 0.0;
}

std::vector<PointPair> mergeSameSources(std::vector<PointPair> pairs) {
  std::sort(pairs.begin(), pairs.end(), [](const PointPair& a, const PointPair& b) {
    return a.source.x() != b.source.x() ? a.source.x() < b.source.x() : a.source.y() < b.source.y();
  });
  std::vector<PointPair> merged;
  for (std::size_t i = 0; i < pairs.size();) {
    PointPair group{pairs[i].source, Eigen::Vector2d::Zero()};
    std::size_t end = i;
    for (; end < pairs.size() && pairs[end].source == group.source; ++end) group.target += pairs[end].target;
    group.target /= static_cast<double>(end - i);
    merged.push_back(group);
    i = end;
  }
  return merged;
}

}  // namespace

Result<Affine2> fitAffine(const std::vector<PointPair>& pairs) {
  if (!spansPlane(pairs)) {
    return fail(ErrorCode::kDegenerate, "An affine map needs three anchors that are not on one line");
  }
  const Eigen::Vector2d source_mean = meanSource(pairs);
  Eigen::Vector2d target_mean = Eigen::Vector2d::Zero();
  for (const PointPair& pair : pairs) target_mean += pair.target / static_cast<double>(pairs.size());
  Eigen::Matrix2d mixed = Eigen::Matrix2d::Zero();
  Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();
  for (const PointPair& pair : pairs) {
    mixed += (pair.target - target_mean) * (pair.source - source_mean).transpose();
    scatter += (pair.source - source_mean) * (pair.source - source_mean).transpose();
  }
  Affine2 affine;
  affine.linear = mixed * scatter.inverse();
  affine.translation = target_mean - affine.linear * source_mean;
  return affine;
}

Result<ThinPlateSpline> ThinPlateSpline::fit(const std::vector<PointPair>& pairs) {
  if (!spansPlane(pairs)) {  // also what is not finite, which could not be sorted below
    return fail(ErrorCode::kDegenerate, "A thin-plate spline needs three anchors that are not on one line");
  }
  const std::vector<PointPair> merged = mergeSameSources(pairs);
  ThinPlateSpline spline;
  spline.center_ = meanSource(merged);
  double squares = 0.0;
  for (const PointPair& pair : merged) squares += (pair.source - spline.center_).squaredNorm();
  spline.unit_ = std::sqrt(squares / static_cast<double>(merged.size()));
  for (const PointPair& pair : merged) spline.knots_.emplace_back((pair.source - spline.center_) / spline.unit_);

  const auto count = static_cast<Eigen::Index>(merged.size());
  Eigen::MatrixXd system = Eigen::MatrixXd::Zero(count + 3, count + 3);
  Eigen::Matrix<double, Eigen::Dynamic, 2> targets = Eigen::Matrix<double, Eigen::Dynamic, 2>::Zero(count + 3, 2);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Eigen::Vector2d& knot = spline.knots_[static_cast<std::size_t>(i)];
    for (Eigen::Index j = 0; j < i; ++j) {
      system(i, j) = radialBasis((knot - spline.knots_[static_cast<std::size_t>(j)]).squaredNorm());
      system(j, i) = system(i, j);
    }
    system.row(i).tail<3>() << 1.0, knot.x(), knot.y();
    system.col(i).tail<3>() = system.row(i).tail<3>().transpose();
    targets.row(i) = merged[static_cast<std::size_t>(i)].target.transpose();
  }
  spline.coefficients_ = system.fullPivLu().solve(targets);
  if (!spline.coefficients_.allFinite()) {
    return fail(ErrorCode::kDegenerate, "The thin-plate spline of these anchors has no finite solution");
  }
  return spline;
}

Eigen::Vector2d ThinPlateSpline::operator*(const Eigen::Vector2d& point) const {
  const Eigen::Vector2d at = (point - center_) / unit_;
  const auto count = static_cast<Eigen::Index>(knots_.size());
  Eigen::Vector2d sum = coefficients_.row(count).transpose() + at.x() * coefficients_.row(count + 1).transpose() +
                        at.y() * coefficients_.row(count + 2).transpose();
  for (Eigen::Index i = 0; i < count; ++i) {
    sum += radialBasis((at - knots_[static_cast<std::size_t>(i)]).squaredNorm()) * coefficients_.row(i).transpose();
  }
  return sum;
}

}  // namespace cad2slam
