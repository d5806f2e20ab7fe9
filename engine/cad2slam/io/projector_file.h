// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "cad2slam/core/result.h"
#include "cad2slam/projection/projector.h"
#include "cad2slam/projection/projector_data.h"

namespace cad2slam {

/// The projector file `.c2s` (DESIGN.md section 5): byte layout of safetensors. Needs neither Ceres nor OpenCV.
inline constexpr int kProjectorFormatMajor = 1;
inline constexpr int kProjectorFormatMinor = 0;

/// The bytes of a file; the same data gives the same bytes.
[[nodiscard]] Result<std::string> formatProjectorFile(const ProjectorData& data);
[[nodiscard]] Result<void> writeProjectorFile(const std::filesystem::path& path, const ProjectorData& data);

/// Everything in the file, checked: layout, sizes before allocation, SHA-256, finite numbers, indices, check poses.
[[nodiscard]] Result<ProjectorData> parseProjectorFile(std::string_view bytes, const std::string& file_name);
[[nodiscard]] Result<ProjectorData> readProjectorFile(const std::filesystem::path& path);

/// Only the function, straight from the mapped file, with the same checks. This is what robots call.
[[nodiscard]] Result<Projector> loadProjector(const std::filesystem::path& path);
[[nodiscard]] Result<Projector> loadProjector(std::string_view bytes, const std::string& file_name);

}  // namespace cad2slam
