// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "cad2slam/core/result.h"
#include "cad2slam/exports/feature.h"

namespace cad2slam {

/// GeoJSON (RFC 7946) with metres of a map instead of degrees: Point, LineString, Polygon and their Multi... forms in
/// a FeatureCollection, a Feature or alone. `properties.name` names a feature; the heading of a point is
/// `properties.heading_rad`, `theta` or `yaw`, radians. A third coordinate is dropped. kMalformed names the value.
[[nodiscard]] Result<FeatureList> parseGeoJson(std::string_view text, const std::string& file_name);
[[nodiscard]] Result<FeatureList> readGeoJson(const std::filesystem::path& path);

/// A FeatureCollection whose features all have `properties.frame` = `frame`; all other properties and ids are kept, and
/// headings stay under the key that they were read from.
[[nodiscard]] Result<std::string> formatGeoJson(const FeatureList& features, const std::string& frame);

}  // namespace cad2slam
