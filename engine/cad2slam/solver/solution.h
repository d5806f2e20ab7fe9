// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

#include "cad2slam/anchors/anchor.h"
#include "cad2slam/geometry/pose2.h"
#include "cad2slam/geometry/similarity2.h"
#include "cad2slam/solver/solver_settings.h"

namespace cad2slam {

/// How well one anchor is met.
struct AnchorFit {
  AnchorId id = 0;
  bool used = true;                                     ///< false for disabled anchors: their residual is a check value
  Eigen::Vector2d predicted = Eigen::Vector2d::Zero();  ///< [m] where the mesh puts the blueprint point in the SLAM map
  Eigen::Vector2d predicted_without =
      Eigen::Vector2d::Zero();   ///< [m] the same without this anchor (one factorisation)
  double residual_m = 0.0;       ///< |predicted - clicked|
  double leave_one_out_m = 0.0;  ///< |predicted_without - clicked|
  double loss_weight = 1.0;      ///< 1 = fully trusted, near 0 = treated as an outlier
};

struct SolveSeconds {
  double ordering = 0.0;
  double optimisation = 0.0;
  double diagnosis = 0.0;  ///< leave-one-out residuals
};

/// Poses and log-stretches of all nodes, as in a Solution.
struct NodeStates {
  std::vector<Pose2> slam;
  std::vector<Eigen::Vector2d> stretch;
};

/// A solved mesh. A value: shares nothing with the solver that made it.
struct Solution {
  SolverSettings settings;       ///< as used, with every automatic weight filled in
  Similarity2 global_fit;        ///< slam_from_blueprint of the start; its scale is the scale of the rest lengths
  std::vector<Pose2> node_slam;  ///< slam_from_node
  std::vector<Eigen::Vector2d> node_stretch;  ///< log-stretch along the node's x and y; zero in the rigid model
  std::optional<NodeStates> minimum;  ///< of the objective, where something was mixed in: where a next solve starts
  double plate_share = 0.0;           ///< part of a thin plate that was mixed into the minimum of the objective
  double similarity_share = 0.0;      ///< part of the global fit that was then mixed in: near 1 where nothing bends
  std::vector<AnchorFit> anchors;     ///< one for each given anchor, in the given order
  std::size_t anchors_used = 0;
  double cost = 0.0;               ///< half the sum of squares, as Ceres counts
  double initial_cost = 0.0;       ///< at the global fit
  double relative_gradient = 0.0;  ///< |gradient| at the end over |gradient| at the global fit, max norm
  int iterations = 0;
  bool converged = false;
  SolveSeconds seconds;
  std::vector<std::string> warnings;  ///< full sentences
};

}  // namespace cad2slam
