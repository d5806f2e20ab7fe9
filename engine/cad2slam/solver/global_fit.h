// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "cad2slam/anchors/anchor.h"
#include "cad2slam/core/result.h"
#include "cad2slam/geometry/similarity2.h"
#include "cad2slam/geometry/similarity_fit.h"
#include "cad2slam/solver/solver_settings.h"

namespace cad2slam {

/// The similarity slam_from_blueprint that a solve starts from and takes its rest lengths from (DESIGN.md section 3).
/// Uses the enabled anchors only. With kToScale and fewer than 3 anchors the scale is 1. One anchor, or several at one
/// place, give a translation. kDegenerate without an enabled anchor.
[[nodiscard]] Result<Similarity2> fitGlobally(const AnchorList& anchors, const ScaleSettings& scale);

/// The places of the enabled anchors, in their order: from the blueprint to the SLAM map.
[[nodiscard]] std::vector<PointPair> enabledPairs(const AnchorList& anchors);

/// Number of places [m apart in the blueprint] that the enabled anchors really tell apart, counted up to 3.
[[nodiscard]] int distinctPlaces(const AnchorList& anchors);

}  // namespace cad2slam
