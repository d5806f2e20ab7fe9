// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include <cstdint>

#include "cad2slam/io/anchors_csv.h"
#include "fuzz/require.h"

using namespace cad2slam;

/// What was accepted is written and read back as it was, with nothing rejected.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
  const Result<AnchorImport> read = parseAnchorsCsv({reinterpret_cast<const char*>(bytes), count}, "a.csv");
  if (!read) {
    fuzz::require(!read.error().message.empty() && read.error().where.rfind("a.csv", 0) == 0, "error without place");
    return 0;
  }
  for (const RejectedLine& line : read->rejected) fuzz::require(line.line > 0 && !line.reason.empty(), "silent reject");
  const std::string written = formatAnchorsCsv(read->anchors);
  const Result<AnchorImport> again = parseAnchorsCsv(written, "a.csv");
  fuzz::require(again.has_value() && again->rejected.empty(), "written CSV is refused: " + written);
  fuzz::require(again->anchors == read->anchors, "anchors change: " + written);
  fuzz::require(formatAnchorsCsv(again->anchors) == written, "no fixed point");
  return 0;
}
