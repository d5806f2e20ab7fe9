// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "cad2slam/io/anchors_csv.h"
#include "fuzz/property.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace cad2slam;
  const auto read = parseAnchorsCsv({reinterpret_cast<const char*>(data), size}, "anchors.csv");
  if (!read) return 0;
  const std::string written = formatAnchorsCsv(read->anchors);
  const auto again = parseAnchorsCsv(written, "anchors.csv");
  fuzzing::expect(again.has_value(), "what was written can be read");
  fuzzing::expect(again->rejected.empty(), "no written line is rejected");
  fuzzing::expect(again->anchors == read->anchors, "written anchors are those that were read");
  return 0;
}
