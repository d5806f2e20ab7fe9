// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include <cstdint>
#include <string>

#include "cad2slam/io/rmf_building.h"
#include "fuzz/require.h"

using namespace cad2slam;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
  const std::string text(reinterpret_cast<const char*>(bytes), count);
  const Result<RmfBuilding> building = parseRmfBuilding(text, "a.building.yaml");
  if (!building) {
    fuzz::require(!building.error().message.empty(), "error without message");
    return 0;
  }
  const Result<MapFrame> frame = MapFrame::create(0.05, 100, 80, {});
  for (const auto& [name, level] : building->levels) {
    for (const Feature& lane : lanesOf(level, *frame)) fuzz::require(!lane.parts.empty(), "a lane without a place");
    for (const auto& [layer, marks] : level.layers) {
      const Result<AnchorList> anchors = anchorsOf(level, layer, *frame, *frame);
      if (!anchors) continue;
      for (const Anchor& anchor : *anchors) {
        fuzz::require(anchor.in_blueprint.allFinite() && anchor.in_slam.allFinite(), "an anchor that is not finite");
      }
    }
  }
  return 0;
}
