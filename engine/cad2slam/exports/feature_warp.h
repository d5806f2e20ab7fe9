// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "cad2slam/core/result.h"
#include "cad2slam/exports/feature.h"
#include "cad2slam/projection/projector.h"
#include "cad2slam/projection/raster_warper.h"

namespace cad2slam {

struct FeatureWarpOptions {
  WarpDirection direction = WarpDirection::kToSlam;
  OutsidePolicy outside = OutsidePolicy::kError;
  /// A straight edge becomes a bent one; it is written with so many vertices that no place of it is farther than this
  /// from what is written [m].
  double chord_error_m = 0.01;
};

struct WarpedFeatures {
  FeatureList features;
  std::size_t vertices_before = 0;
  std::size_t vertices_after = 0;
  double largest_sagitta_m = 0.0;     ///< largest distance of a warped edge from the chord of its own ends
  std::vector<std::string> warnings;  ///< e.g. a polygon that crosses itself after warping
};

/// Features of one frame in the other. kOutOfDomain names the first feature of which a place has no answer, and the
/// place; a chord error that is not positive.
[[nodiscard]] Result<WarpedFeatures> warpFeatures(const Projector& projector, const FeatureList& features,
                                                  const FeatureWarpOptions& options);

/// Whether two edges of a closed ring that are not neighbours touch or cross.
[[nodiscard]] bool crossesItself(const PointList& ring);

}  // namespace cad2slam
