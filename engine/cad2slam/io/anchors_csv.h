// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "cad2slam/anchors/anchor.h"
#include "cad2slam/core/result.h"

namespace cad2slam {

/// A line that could not be read as an anchor.
struct RejectedLine {
  std::size_t line = 0;  ///< 1-based
  std::string reason;    ///< no trailing period
};

struct AnchorImport {
  AnchorList anchors;
  std::vector<RejectedLine> rejected;
};

/// Anchors CSV (DESIGN.md section 5): `id,blueprint_x,blueprint_y,slam_x,slam_y[,enabled,name,note]`, metres.
/// Tolerant: columns found by a header in any order, or in the order above without one; separated by comma, semicolon,
/// tab or spaces; decimal comma where the separator is not a comma; quoted fields; `#` comments; blank lines; BOM;
/// CRLF. A line that cannot be read, repeats an id or goes beyond kLargestCoordinate is rejected by number and the
/// others are kept. kMalformed only when no line at all can be read as an anchor and the text is not just a header.
[[nodiscard]] Result<AnchorImport> parseAnchorsCsv(std::string_view text, const std::string& file_name);
[[nodiscard]] Result<AnchorImport> readAnchorsCsv(const std::filesystem::path& path);

/// Always all eight columns; numbers in the shortest form that reads back exactly.
[[nodiscard]] std::string formatAnchorsCsv(const AnchorList& anchors);
[[nodiscard]] Result<void> writeAnchorsCsv(const std::filesystem::path& path, const AnchorList& anchors);

/// The correspondence file of the paper's authors: a sequence of `"CorrespondenceAnchor" : { "_cad_point" : [x, y],
/// "_slam_point" : [x, y] }` objects, metres, which are map_server frames with the origin at the top-left corner.
/// Ids count from 1.
[[nodiscard]] Result<AnchorImport> parseAuthorsAnchors(std::string_view text, const std::string& file_name);
[[nodiscard]] Result<AnchorImport> readAuthorsAnchors(const std::filesystem::path& path);

/// Reads any of the above, by content rather than extension. Points of QGIS are refused: see qgis_points.h.
[[nodiscard]] Result<AnchorImport> readAnchors(const std::filesystem::path& path);

}  // namespace cad2slam
