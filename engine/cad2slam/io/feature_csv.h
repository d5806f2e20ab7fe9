// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "cad2slam/core/result.h"
#include "cad2slam/exports/feature.h"

namespace cad2slam {

/// Features as CSV, one vertex a line: columns `feature,kind,part,x,y,theta,name` in any order under a header; kind is
/// point, path or polygon. Only x and y [m] are needed: without `feature` each line is a point of its own. Lines of one
/// feature and part stand together and in order. kMalformed names the line.
[[nodiscard]] Result<FeatureList> parseFeatureCsv(std::string_view text, const std::string& file_name);
[[nodiscard]] Result<FeatureList> readFeatureCsv(const std::filesystem::path& path);

/// All seven columns; numbers in the shortest form that reads back exactly.
[[nodiscard]] std::string formatFeatureCsv(const FeatureList& features);

/// By extension: .csv, else GeoJSON.
[[nodiscard]] Result<FeatureList> readFeatures(const std::filesystem::path& path);

}  // namespace cad2slam
