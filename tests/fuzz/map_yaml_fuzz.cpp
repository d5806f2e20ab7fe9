// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0

#include <cstddef>
#include <cstdint>
#include <string>

#include "cad2slam/io/map_yaml.h"
#include "fuzz/property.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace cad2slam;
  const auto read = parseMapYaml(std::string(reinterpret_cast<const char*>(data), size), "map.yaml");
  if (!read) return 0;
  const std::string written = formatMapYaml(read->metadata, "map.png");
  const auto again = parseMapYaml(written, "map.yaml");
  fuzzing::expect(again.has_value(), "what was written can be read");
  fuzzing::expect(formatMapYaml(again->metadata, "map.png") == written, "writing what was read changes nothing");
  return 0;
}
