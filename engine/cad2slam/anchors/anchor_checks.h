// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "cad2slam/anchors/anchor.h"
#include "cad2slam/core/result.h"
#include "cad2slam/map/map_frame.h"

namespace cad2slam {

/// Frames an anchor list is checked against; a missing frame is not checked.
struct AnchorFrames {
  std::optional<MapFrame> blueprint;
  std::optional<MapFrame> slam;
};

/// Names the first anchors no solve can be built on: kMalformed for non-finite coordinates or an id used twice,
/// kOutOfDomain for a point farther outside its raster than a tenth of the raster's diagonal,
/// kDegenerate for two enabled anchors at one place of the blueprint that disagree in the SLAM map (or the reverse).
/// Disabled anchors only have to be finite.
[[nodiscard]] Result<void> checkAnchors(const AnchorList& anchors, const AnchorFrames& frames);

}  // namespace cad2slam
