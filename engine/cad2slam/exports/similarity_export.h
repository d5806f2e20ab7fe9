// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <string>
#include <vector>

#include "cad2slam/core/result.h"
#include "cad2slam/exports/feature.h"
#include "cad2slam/exports/level_transform.h"
#include "cad2slam/projection/projector.h"

namespace cad2slam {

/// The similarity that comes nearest to the projector where it matters: at the vertices of the features and, on paths,
/// every `spacing_m` between them; without features at the middles of all tiles. Fitted by least squares, with what it
/// leaves at the worst place. At most `reference_count` places, spread evenly, become the references.
/// kOutOfDomain: a place without an answer; kDegenerate: fewer than two places.
[[nodiscard]] Result<LevelTransform> fitLevelTransform(const Projector& projector, const FeatureList& features,
                                                       double spacing_m, std::size_t reference_count);

}  // namespace cad2slam
