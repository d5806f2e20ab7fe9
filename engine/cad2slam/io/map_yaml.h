// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "cad2slam/core/result.h"
#include "cad2slam/io/map_file.h"

namespace cad2slam {

/// The text behind readMapYaml(); `yaml` is named in errors, and `image` is resolved against its folder.
[[nodiscard]] Result<MapYaml> parseMapYaml(const std::string& text, const std::filesystem::path& yaml);

/// A YAML that reads back as exactly this metadata, with `image_name` as it should stand there.
[[nodiscard]] std::string formatMapYaml(const MapMetadata& metadata, const std::string& image_name);

}  // namespace cad2slam
