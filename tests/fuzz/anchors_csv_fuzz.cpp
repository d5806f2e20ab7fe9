// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include <cstdint>

#include "cad2slam/io/anchors_csv.h"
#include "cad2slam/io/qgis_points.h"
#include "fuzz/require.h"

using namespace cad2slam;

namespace {

/// Points of QGIS lie in both maps, or are refused.
void readAsQgisPoints(std::string_view text) {
  static const MapFrame frame = *MapFrame::create(0.05, 2000, 1000, {{-3.0, 2.0}, 0.4});
  const Result<QgisImport> read = parseQgisPoints(text, "a.points", frame, frame);
  if (!read) return fuzz::require(read.error().where.rfind("a.points", 0) == 0, "error without place");
  fuzz::require(looksLikeQgisPoints(text) || text.size() > 4096, "read although it does not look like it");
  for (const Anchor& anchor : read->import.anchors) {
    fuzz::require(!anchor.enabled || (frame.contains(anchor.in_blueprint) && frame.contains(anchor.in_slam)),
                  "a point lies outside");
  }
}

}  // namespace

/// What was accepted is written and read back as it was, with nothing rejected.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
  readAsQgisPoints({reinterpret_cast<const char*>(bytes), count});
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
