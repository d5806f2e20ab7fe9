// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0

#include <cstddef>
#include <cstdint>

#include "cad2slam/io/anchors_csv.h"
#include "fuzz/property.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace cad2slam;
  const auto read = parseAuthorsAnchors({reinterpret_cast<const char*>(data), size}, "correspondences.data");
  if (!read) return 0;
  for (const Anchor& anchor : read->anchors) {
    fuzzing::expect(anchor.in_blueprint.allFinite() && anchor.in_slam.allFinite(), "anchors are finite");
  }
  return 0;
}
