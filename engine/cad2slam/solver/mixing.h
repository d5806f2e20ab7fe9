// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include <vector>

#include "cad2slam/anchors/anchor.h"
#include "cad2slam/geometry/similarity2.h"
#include "cad2slam/mesh/mesh.h"
#include "cad2slam/solver/solution.h"
#include "cad2slam/solver/thin_plate_fit.h"

namespace cad2slam {

// What the stretch model's answer is made of beside the minimum of its objective. `cad2slam-cli evaluate sites`
// measures what it brings.

/// How much of a plate through the enabled anchors should go into the answer, 0 to 1. A plate errs in other ways than a
/// mesh, so a mean of both is often better than either. Compares the leave-one-out residuals of mixtures; `mesh` is a
/// solution without a plate. None below 20 anchors, which are too few to tell (on real buildings it then does harm),
/// and never more than seven tenths.
[[nodiscard]] double plateShare(const AnchorList& anchors, const Solution& mesh, const ThinPlateFit& plate);

/// The plate at the centre of each node of a mesh.
using PlateAtNodes = std::vector<ThinPlateFit::Linearisation>;
[[nodiscard]] PlateAtNodes atNodes(const ThinPlateFit& plate, const Mesh& mesh);

/// Moves place, heading and stretch of `nodes` `share` (0 to 1) of the way to those of the plate at their centres.
/// False, with nothing changed, where the plate folds or nearly does.
[[nodiscard]] bool mixIn(const PlateAtNodes& plate, double share, const std::vector<NodeIndex>& nodes,
                         Solution& solution);

/// For each enabled anchor where the global fit of all others puts it, relative to where it was clicked [m].
[[nodiscard]] std::vector<Eigen::Vector2d> similarityLeaveOneOut(const AnchorList& anchors, const ScaleSettings& scale);

/// How much of the global fit should go into the answer, 0 to 1: a lot where it meets anchors it has not seen as well
/// as `solution` does, as in small flats with few noisy anchors. None where both miss them by more than noise could.
[[nodiscard]] double similarityShare(const Solution& solution, const std::vector<Eigen::Vector2d>& leave_one_out);

/// Moves `nodes` `share` of the way to the solution's own global fit.
void mixInSimilarity(double share, const Mesh& mesh, const std::vector<NodeIndex>& nodes, Solution& solution);

/// Where the projector with its smooth weights puts a place [m] of the blueprint (DESIGN.md section 4).
[[nodiscard]] Eigen::Vector2d blended(const Mesh& mesh, const Solution& solution,
                                      const Eigen::Vector2d& point_in_blueprint);

}  // namespace cad2slam
