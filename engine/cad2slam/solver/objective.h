// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <vector>

#include "cad2slam/geometry/similarity2.h"
#include "cad2slam/mesh/mesh.h"
#include "cad2slam/solver/node_blend.h"
#include "cad2slam/solver/solver_settings.h"

namespace cad2slam {

/// Unknowns of a node: [x_m, y_m, heading_rad] in the rigid model, [x_m, y_m, heading_rad, a_x, a_y] with stretch.
inline constexpr int kRigidUnknowns = 3;
inline constexpr int kStretchUnknowns = 5;

/// Edge of the mesh with everything that stays constant during a solve.
struct EdgeTerm {
  std::uint32_t from = 0;  ///< number among the active nodes
  std::uint32_t to = 0;
  Eigen::Vector2d rest;      ///< Z_ij = s (t_j - t_i) [m]
  Eigen::Matrix2d whitener;  ///< Lambda^(1/2) R_ij^T
};

/// Anchor with the nodes that predict it. `nodes` of the blend are numbers among the active nodes.
struct AnchorTerm {
  NodeBlend blend;
  std::array<Eigen::Vector2d, NodeBlend::kCapacity> offsets;  ///< s (p^b - t_i^b) [m]
  Eigen::Vector2d target;                                     ///< p^s [m]
};

/// The objective of DESIGN.md section 3 over the active nodes (those of components that hold an anchor):
///     cost = 1/2 sum |r_edge|^2 + 1/2 sum |r_node|^2 + 1/2 sum rho(k |e_anchor|^2)
/// with edge and node residuals as given there and e_anchor = sum_i w_i (t_i + R(theta_i) diag(exp(a_i)) o_i) - p^s,
/// which for one node is the paper's eq. 4 turned into the SLAM frame.
struct Objective {
  int unknowns = kStretchUnknowns;      ///< of each node
  std::vector<NodeIndex> active_nodes;  ///< mesh number of each active node
  std::vector<EdgeTerm> edges;
  std::vector<AnchorTerm> anchors;
  double sqrt_lambda_theta = 0.0;
  double sqrt_lambda_stretch = 0.0;
  double sqrt_prior = 0.0;            ///< of mu_iso = mu_0 times the area of a tile
  std::vector<double> heading_prior;  ///< sqrt of the weight that ties a node's heading to the global fit; mostly 0
  double prior_heading = 0.0;         ///< [rad]
  double anchor_information = 1.0;    ///< k
  double loss_width_m = 0.0;          ///< 0: squared loss

  [[nodiscard]] std::size_t nodeCount() const { return active_nodes.size(); }
  [[nodiscard]] std::size_t size() const { return active_nodes.size() * static_cast<std::size_t>(unknowns); }
};

/// rho'(k |e|^2) of the Cauchy loss: how much of an anchor with this residual [m] still counts.
[[nodiscard]] inline double lossWeight(double squared_residual_m2, double loss_width_m) {
  return loss_width_m > 0.0 ? 1.0 / (1.0 + squared_residual_m2 / (loss_width_m * loss_width_m)) : 1.0;
}

/// 1/2 rho(k |e|^2).
[[nodiscard]] double anchorCost(double squared_residual_m2, double information, double loss_width_m);

/// Residual of an edge: [along, across, heading, a_x, a_y], and its derivatives by the unknowns of both nodes.
/// Only the first three rows and the first three columns of each block mean something in the rigid model.
struct EdgeLinearisation {
  Eigen::Matrix<double, 5, 1> residual;
  Eigen::Matrix<double, 2, 5> from;  ///< d (along, across) / d node i
  Eigen::Matrix<double, 2, 5> to;    ///< d (along, across) / d node j
};
[[nodiscard]] EdgeLinearisation linearise(const Objective& objective, const EdgeTerm& edge, const double* from,
                                          const double* to);
/// The residual alone.
[[nodiscard]] Eigen::Matrix<double, 5, 1> residualOf(const Objective& objective, const EdgeTerm& edge,
                                                     const double* from, const double* to);

/// e_anchor [m], unweighted.
[[nodiscard]] Eigen::Vector2d residualOf(const Objective& objective, const AnchorTerm& anchor, const double* unknowns);
/// d e_anchor / d unknowns of the k-th node of its blend.
[[nodiscard]] Eigen::Matrix<double, 2, 5> derivativeOf(const Objective& objective, const AnchorTerm& anchor,
                                                       std::size_t k, const double* unknowns);

/// The cost at `x` (size() numbers, active nodes one after the other).
[[nodiscard]] double costAt(const Objective& objective, const double* x);

/// Cost and gradient at `x`.
[[nodiscard]] double gradientAt(const Objective& objective, const double* x, double* gradient);

}  // namespace cad2slam
