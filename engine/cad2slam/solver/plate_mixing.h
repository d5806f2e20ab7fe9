// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "cad2slam/mesh/mesh.h"
#include "cad2slam/solver/solution.h"
#include "cad2slam/solver/thin_plate_fit.h"

namespace cad2slam {

/// Moves place, heading and stretch of every node `share` (0 to 1) of the way to those of the plate at its centre.
/// False, with nothing changed, where the plate folds or nearly does.
[[nodiscard]] bool mixIn(const ThinPlateFit& plate, double share, const Mesh& mesh, Solution& solution);

/// Where the projector with its smooth weights puts a place [m] of the blueprint (DESIGN.md section 4).
[[nodiscard]] Eigen::Vector2d blended(const Mesh& mesh, const Solution& solution,
                                      const Eigen::Vector2d& point_in_blueprint);

}  // namespace cad2slam
