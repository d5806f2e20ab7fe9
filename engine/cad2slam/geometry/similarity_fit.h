// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include <optional>
#include <vector>

#include "cad2slam/core/result.h"
#include "cad2slam/geometry/similarity2.h"

namespace cad2slam {

/// A point known in two frames.
struct PointPair {
  Eigen::Vector2d source = Eigen::Vector2d::Zero();  ///< [m]
  Eigen::Vector2d target = Eigen::Vector2d::Zero();  ///< [m]
};

/// Closed-form weighted least squares of sum_i w_i |target_i - S source_i|^2 over similarities S (Horn 1987 in the
/// plane). `fixed_scale` keeps the scale at a number; without it the scale is estimated. Empty `weights` means all 1.
/// kDegenerate: no pair, or all source points at one place while rotation has to be found (one pair with a
/// fixed scale gives a pure translation). Never returns a reflection.
[[nodiscard]] Result<Similarity2> fitSimilarity(const std::vector<PointPair>& pairs, std::optional<double> fixed_scale,
                                                const std::vector<double>& weights = {});

/// As fitSimilarity, but a few pairs that are wrong by far do not spoil it: iteratively reweighted least squares with
/// a Cauchy loss whose width starts at the spread of the residuals and shrinks to their median.
[[nodiscard]] Result<Similarity2> fitSimilarityRobust(const std::vector<PointPair>& pairs,
                                                      std::optional<double> fixed_scale);

/// The same fit with the source mirrored about its x axis first; its cost against fitSimilarity's tells whether a
/// blueprint was loaded mirrored.
[[nodiscard]] Result<Similarity2> fitMirroredSimilarity(const std::vector<PointPair>& pairs,
                                                        std::optional<double> fixed_scale);

/// Root mean square of |target_i - S source_i|, metres; 0 for no pairs.
[[nodiscard]] double rmsResidual(const Similarity2& similarity, const std::vector<PointPair>& pairs);

}  // namespace cad2slam
