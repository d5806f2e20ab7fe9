// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>

#include <memory>
#include <vector>

#include "cad2slam/core/result.h"
#include "cad2slam/evaluation/alignment_method.h"
#include "cad2slam/evaluation/anchor_errors.h"
#include "cad2slam/evaluation/error_statistics.h"
#include "cad2slam/map/occupancy_grid.h"
#include "cad2slam/simulation/true_warp.h"

namespace cad2slam {

/// A place of the free space and where it really is in the SLAM map.
struct TruePlace {
  Eigen::Vector2d in_blueprint = Eigen::Vector2d::Zero();
  Pose2 in_slam;  ///< of the blueprint pose with heading 0
};

/// Places on a square grid over the free pixels for which the truth is known.
[[nodiscard]] std::vector<TruePlace> truePlaces(const OccupancyGrid& blueprint, const TrueWarp& truth,
                                                double spacing_m);

struct TruthErrors {
  std::vector<TruePlace> places;
  std::vector<MethodErrors> methods;  ///< at `places` [m]
  ErrorStatistics heading_rad{};      ///< of the stretch model's projector; empty when it is not among the methods
  std::size_t outside = 0;            ///< places the stretch model's mesh does not hold
};

/// Fits each method to the anchors and compares it with the truth all over the free space. kDegenerate: the truth
/// covers no free place, or an error of fitting.
[[nodiscard]] Result<TruthErrors> evaluateTruth(const std::shared_ptr<const Mesh>& mesh, const AnchorList& anchors,
                                                const OccupancyGrid& blueprint, const TrueWarp& truth,
                                                const EvaluationOptions& options, double spacing_m = 0.25);

}  // namespace cad2slam
