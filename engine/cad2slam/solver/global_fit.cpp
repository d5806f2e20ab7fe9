// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/solver/global_fit.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace cad2slam {
namespace {

/// Places nearer than this [m] to each other say nothing about rotation.
constexpr double kSamePlace_m = 1e-3;

/// Sum of squared residuals with each residual capped at three times the robust standard deviation, so that one wrong
/// anchor does not drown what the others say about the scale.
double cappedSquares(const Similarity2& fit, const std::vector<PointPair>& pairs) {
  std::vector<double> squares;
  for (const PointPair& pair : pairs) squares.push_back((pair.target - fit * pair.source).squaredNorm());
  std::vector<double> sorted = squares;
  std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2), sorted.end());
  const double median = sorted[sorted.size() / 2];
  const double cap = 9.0 * median / 1.386;  // the median of a Rayleigh square is 2 ln 2 sigma^2
  double sum = 0.0;
  for (const double square : squares) sum += cap > 0.0 ? std::min(square, cap) : square;
  return sum;
}

/// Posterior mean of the log-scale: a plan that claims to be to scale is within 1 % nine times of ten, otherwise
/// anything goes.
double shrunkScale(const Similarity2& least_squares, const std::vector<PointPair>& pairs) {
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const PointPair& pair : pairs) mean += pair.source / static_cast<double>(pairs.size());
  double spread = 0.0;
  for (const PointPair& pair : pairs) spread += (pair.source - mean).squaredNorm();
  const double scale = least_squares.scale;
  const double freedom = 2.0 * static_cast<double>(pairs.size()) - 4.0;
  const double variance = 3.0 * cappedSquares(least_squares, pairs) / freedom / (scale * scale * spread);
  const double log_scale = std::log(scale);
  double total = 0.0;
  double mean_log = 0.0;
  for (const auto& [probability, sigma] : {std::pair{0.9, 0.01}, std::pair{0.1, 0.5}}) {
    const double prior = sigma * sigma;
    const double evidence = variance + prior;
    const double weight = probability * std::exp(-0.5 * log_scale * log_scale / evidence) / std::sqrt(evidence);
    total += weight;
    mean_log += weight * log_scale * prior / evidence;
  }
  return total > 0.0 ? std::exp(mean_log / total) : scale;
}

}  // namespace

std::vector<PointPair> enabledPairs(const AnchorList& anchors) {
  std::vector<PointPair> pairs;
  for (const Anchor& anchor : anchors) {
    if (anchor.enabled) pairs.push_back({anchor.in_blueprint, anchor.in_slam});
  }
  return pairs;
}

int distinctPlaces(const AnchorList& anchors) {
  std::vector<Eigen::Vector2d> places;
  for (const Anchor& anchor : anchors) {
    const bool known = std::any_of(places.begin(), places.end(), [&](const Eigen::Vector2d& place) {
      return (place - anchor.in_blueprint).norm() <= kSamePlace_m;
    });
    if (anchor.enabled && !known) places.push_back(anchor.in_blueprint);
    if (places.size() == 3) break;
  }
  return static_cast<int>(places.size());
}

Result<Similarity2> fitGlobally(const AnchorList& anchors, const ScaleSettings& scale) {
  const std::vector<PointPair> pairs = enabledPairs(anchors);
  if (pairs.empty()) {
    return fail(ErrorCode::kDegenerate,
                "there is no enabled anchor; at least one pair of corresponding points is needed");
  }
  if (scale.rule == ScaleRule::kFixed && !(scale.fixed_scale > 0.0 && std::isfinite(scale.fixed_scale))) {
    return fail(ErrorCode::kOutOfDomain, "the scale must be a positive number");
  }
  const double known_scale = scale.rule == ScaleRule::kFixed ? scale.fixed_scale : 1.0;
  const int places = distinctPlaces(anchors);
  if (places == 1) {
    PointPair mean;
    for (const PointPair& pair : pairs) {
      mean.source += pair.source / static_cast<double>(pairs.size());
      mean.target += pair.target / static_cast<double>(pairs.size());
    }
    return fitSimilarity({mean}, known_scale);
  }
  if (scale.rule == ScaleRule::kFixed || (scale.rule == ScaleRule::kToScale && places == 2)) {
    return fitSimilarityRobust(pairs, known_scale);
  }
  Result<Similarity2> free_fit = fitSimilarityRobust(pairs, std::nullopt);
  if (!free_fit || scale.rule == ScaleRule::kLeastSquares) return free_fit;
  return fitSimilarityRobust(pairs, shrunkScale(*free_fit, pairs));
}

}  // namespace cad2slam
