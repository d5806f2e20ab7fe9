// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/geometry/similarity_fit.h"

#include <algorithm>
#include <cmath>

namespace cad2slam {
namespace {

/// Sums that every closed-form fit is made of, about the weighted means.
struct Moments {
  Eigen::Vector2d mean_source = Eigen::Vector2d::Zero();
  Eigen::Vector2d mean_target = Eigen::Vector2d::Zero();
  double dot = 0.0;      ///< sum w  s . t
  double cross = 0.0;    ///< sum w  s x t
  double squared = 0.0;  ///< sum w |s|^2
  double magnitude = 0.0;
};

Moments momentsOf(const std::vector<PointPair>& pairs, const std::vector<double>& weights) {
  const auto weight = [&weights](std::size_t i) { return weights.empty() ? 1.0 : weights[i]; };
  Moments moments;
  double total = 0.0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    moments.mean_source += weight(i) * pairs[i].source;
    moments.mean_target += weight(i) * pairs[i].target;
    total += weight(i);
  }
  moments.mean_source /= total;
  moments.mean_target /= total;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const Eigen::Vector2d s = pairs[i].source - moments.mean_source;
    const Eigen::Vector2d t = pairs[i].target - moments.mean_target;
    moments.dot += weight(i) * s.dot(t);
    moments.cross += weight(i) * (s.x() * t.y() - s.y() * t.x());
    moments.squared += weight(i) * s.squaredNorm();
    moments.magnitude = std::max({moments.magnitude, pairs[i].source.squaredNorm(), pairs[i].target.squaredNorm()});
  }
  return moments;
}

Similarity2 about(const Moments& moments, double scale, double heading) {
  Similarity2 fit{scale, heading, Eigen::Vector2d::Zero()};
  fit.translation = moments.mean_target - fit * moments.mean_source;
  return fit;
}

std::vector<double> residualNorms(const Similarity2& fit, const std::vector<PointPair>& pairs) {
  std::vector<double> residuals;
  residuals.reserve(pairs.size());
  for (const PointPair& pair : pairs) residuals.push_back((pair.target - fit * pair.source).norm());
  return residuals;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

Result<Similarity2> fitSimilarity(const std::vector<PointPair>& pairs, std::optional<double> fixed_scale,
                                  const std::vector<double>& weights) {
  if (pairs.empty()) return fail(ErrorCode::kDegenerate, "no pair of corresponding points to align with");
  for (const PointPair& pair : pairs) {
    if (!pair.source.allFinite() || !pair.target.allFinite()) {
      return fail(ErrorCode::kMalformed, "a pair of corresponding points is not finite");
    }
  }
  const Moments moments = momentsOf(pairs, weights);
  const bool one_place = moments.squared <= 1e-24 * (1.0 + moments.magnitude);
  if (one_place) {
    if (pairs.size() == 1 && fixed_scale) return about(moments, *fixed_scale, 0.0);
    return fail(ErrorCode::kDegenerate, "all points are at one place, so rotation and scale are unknown");
  }
  const double alignment = std::hypot(moments.dot, moments.cross);
  const double scale = fixed_scale.value_or(alignment / moments.squared);
  if (!(scale > 0.0) || !std::isfinite(scale) || !(alignment > 0.0)) {
    return fail(ErrorCode::kDegenerate, "the points do not determine a rotation and a scale");
  }
  return about(moments, scale, std::atan2(moments.cross, moments.dot));
}

Result<Similarity2> fitSimilarityRobust(const std::vector<PointPair>& pairs, std::optional<double> fixed_scale) {
  Result<Similarity2> fit = fitSimilarity(pairs, fixed_scale);
  // Up to three pairs are met or nearly met by a similarity: nothing tells a wrong one.
  if (!fit || pairs.size() < 4) return fit;
  std::vector<double> residuals = residualNorms(*fit, pairs);
  double width = *std::max_element(residuals.begin(), residuals.end());
  const double smallest_width = 1e-9 * (1.0 + width);
  std::vector<double> weights(pairs.size());
  constexpr int kIterations = 40;
  for (int iteration = 0; iteration < kIterations; ++iteration) {
    width = std::max({smallest_width, 0.7 * width, median(residuals)});
    for (std::size_t i = 0; i < pairs.size(); ++i) weights[i] = 1.0 / (1.0 + std::pow(residuals[i] / width, 2));
    Result<Similarity2> next = fitSimilarity(pairs, fixed_scale, weights);
    if (!next) return fit;
    fit = next;
    residuals = residualNorms(*fit, pairs);
  }
  return fit;
}

Result<Similarity2> fitMirroredSimilarity(const std::vector<PointPair>& pairs, std::optional<double> fixed_scale) {
  std::vector<PointPair> mirrored = pairs;
  for (PointPair& pair : mirrored) pair.source.y() = -pair.source.y();
  return fitSimilarity(mirrored, fixed_scale);
}

double rmsResidual(const Similarity2& similarity, const std::vector<PointPair>& pairs) {
  if (pairs.empty()) return 0.0;
  double sum = 0.0;
  for (const PointPair& pair : pairs) sum += (pair.target - similarity * pair.source).squaredNorm();
  return std::sqrt(sum / static_cast<double>(pairs.size()));
}

}  // namespace cad2slam
