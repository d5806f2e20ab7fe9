// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "cad2slam/core/result.h"
#include "cad2slam/io/anchors_csv.h"
#include "cad2slam/map/map_frame.h"

namespace cad2slam {

/// What the two pairs of columns of a QGIS points file turned out to be.
struct QgisReading {
  bool slam_is_source = true;  ///< sourceX, sourceY lie in the SLAM map and mapX, mapY in the blueprint, or the reverse
  bool target_in_pixels = false;  ///< mapX, mapY are pixels as well: the target picture had no world file
};

struct QgisImport {
  AnchorImport import;
  QgisReading reading;
};

/// Whether a text begins like the points file of QGIS's georeferencer (`<image>.points`).
[[nodiscard]] bool looksLikeQgisPoints(std::string_view text);

/// Ground control points of QGIS's georeferencer as anchors, in metres of both maps. Columns by the names in the
/// header: `mapX,mapY,sourceX,sourceY,enable[,...]`, formerly `pixelX,pixelY`; sources are (column, -row) of the
/// picture.
///
/// The file does not say which picture is which: of the readings that put every enabled point into both maps, the one
/// is taken whose distances agree best. kDegenerate where none does. A line that cannot be read is rejected by
/// number and the others are kept.
[[nodiscard]] Result<QgisImport> parseQgisPoints(std::string_view text, const std::string& file_name,
                                                 const MapFrame& blueprint, const MapFrame& slam);
[[nodiscard]] Result<QgisImport> readQgisPoints(const std::filesystem::path& path, const MapFrame& blueprint,
                                                const MapFrame& slam);

}  // namespace cad2slam
