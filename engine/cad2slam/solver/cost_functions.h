// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ceres/cost_function.h>

#include <memory>

#include "cad2slam/solver/objective.h"

namespace cad2slam {

/// The residuals of the objective as Ceres cost functions; parameter blocks are the unknowns of one node each. They
/// keep references: the objective must outlive them.

/// [along, across, heading] in the rigid model and [along, across, heading, a_x, a_y] with stretch; blocks: i, j.
[[nodiscard]] std::unique_ptr<ceres::CostFunction> makeEdgeCost(const Objective& objective, const EdgeTerm& edge);

/// sqrt(mu) [a_x - a_y, a_x + a_y] and the heading prior of one active node.
[[nodiscard]] std::unique_ptr<ceres::CostFunction> makeNodeCost(const Objective& objective, std::size_t node);

/// sqrt(k) e_anchor; blocks: the nodes of its blend.
[[nodiscard]] std::unique_ptr<ceres::CostFunction> makeAnchorCost(const Objective& objective, const AnchorTerm& anchor);

}  // namespace cad2slam
