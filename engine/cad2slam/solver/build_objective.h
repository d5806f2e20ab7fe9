// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "cad2slam/anchors/anchor.h"
#include "cad2slam/geometry/similarity2.h"
#include "cad2slam/mesh/mesh.h"
#include "cad2slam/solver/objective.h"
#include "cad2slam/solver/solution.h"

namespace cad2slam {

/// Fills in the weights that settings leave to the solver.
[[nodiscard]] SolverSettings withAutomaticWeights(const SolverSettings& settings, const Mesh& mesh, double scale);

/// The objective over the components that hold an enabled anchor. `settings` must have no automatic weight left.
[[nodiscard]] Objective buildObjective(const Mesh& mesh, const AnchorList& anchors, const SolverSettings& settings,
                                       const Similarity2& global_fit);

/// The term of one anchor, its nodes numbered as active nodes; `active_number` maps mesh nodes, kInactive where none.
inline constexpr std::uint32_t kInactive = 0xffffffffU;
[[nodiscard]] std::vector<std::uint32_t> activeNumbers(const Objective& objective, std::size_t node_count);
[[nodiscard]] AnchorTerm makeAnchorTerm(const Mesh& mesh, const NodeBlend& blend, const Eigen::Vector2d& in_blueprint,
                                        const Eigen::Vector2d& in_slam, double scale);

/// Unknowns of the active nodes at the global fit, or at the minimum of `warm_start` where it is given.
[[nodiscard]] Eigen::VectorXd startingPoint(const Objective& objective, const Mesh& mesh, const Similarity2& global_fit,
                                            const Solution* warm_start);

}  // namespace cad2slam
