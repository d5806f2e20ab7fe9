// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cad2slam/core/result.h"
#include "cad2slam/exports/pose_grid.h"
#include "cad2slam/projection/projector.h"
#include "cad2slam/projection/raster_warper.h"

namespace cad2slam {

/// Samples one direction every `step_m` over all places that have an answer, and one and a half cells further with
/// OutsidePolicy::kRigid so that interpolation reaches the border. kOutOfDomain: more than 25 million samples.
[[nodiscard]] Result<PoseGrid> sampleGrid(const Projector& projector, WarpDirection direction, double step_m);

}  // namespace cad2slam
