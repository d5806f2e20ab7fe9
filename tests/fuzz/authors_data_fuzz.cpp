// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include <cstdint>

#include "cad2slam/io/anchors_csv.h"
#include "fuzz/require.h"

using namespace cad2slam;

/// Accepted anchors are finite, numbered upwards and survive our own format.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
  const Result<AnchorImport> read = parseAuthorsAnchors({reinterpret_cast<const char*>(bytes), count}, "a.data");
  if (!read) {
    fuzz::require(!read.error().message.empty() && read.error().where.rfind("a.data", 0) == 0, "error without place");
    return 0;
  }
  AnchorId last = 0;
  for (const Anchor& anchor : read->anchors) {
    fuzz::require(anchor.id > last && anchor.in_blueprint.allFinite() && anchor.in_slam.allFinite(), "odd anchor");
    last = anchor.id;
  }
  const Result<AnchorImport> again = parseAnchorsCsv(formatAnchorsCsv(read->anchors), "a.csv");
  fuzz::require(again.has_value() && again->anchors == read->anchors, "anchors change");
  return 0;
}
