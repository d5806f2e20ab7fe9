// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include <cstdint>

#include "cad2slam/io/map_yaml.h"
#include "fuzz/require.h"

using namespace cad2slam;

/// What is read, written and read again is the same; every error says something.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
  const std::string text(reinterpret_cast<const char*>(bytes), count);
  const Result<MapYaml> read = parseMapYaml(text, "m.yaml");
  if (!read) {
    fuzz::require(!read.error().message.empty() && read.error().where.rfind("m.yaml", 0) == 0, "error without place");
    return 0;
  }
  const MapMetadata& metadata = read->metadata;
  const std::string written = formatMapYaml(metadata, metadata.image.string());
  const Result<MapYaml> again = parseMapYaml(written, "m.yaml");
  fuzz::require(again.has_value(), "written YAML is refused: " + written);
  fuzz::require(again->metadata.image == metadata.image, "image changes: " + written);
  fuzz::require(again->metadata.metric_from_corner.translation == metadata.metric_from_corner.translation &&
                    again->metadata.metric_from_corner.heading == metadata.metric_from_corner.heading,
                "origin changes");
  fuzz::require(formatMapYaml(again->metadata, again->metadata.image.string()) == written, "no fixed point");
  return 0;
}
