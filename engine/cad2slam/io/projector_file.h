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

/// The projector file `.c2s`: byte layout of safetensors. Needs neither Ceres nor OpenCV to read.
///
///     bytes 0..7   u64, little-endian: length N of the header
///     N bytes      JSON {"<array>": {"dtype", "shape", "data_offsets": [begin, end)}, "__metadata__": {text: text}},
///                  filled up with blanks so that the data start on a multiple of 64
///     the rest     arrays, little-endian, row-major, without gaps
///
/// Arrays (n nodes, m edges): node_blueprint f64[n,2] centres [m]; node_slam f64[n,3] slam_from_node x, y [m], heading
/// [rad]; node_stretch f64[n,2] log-stretch; node_tile i32[n,2] column, row in the lattice; edges u32[m,2]; anchors
/// f64[k,4] blueprint x, y, SLAM x, y [m]; check_poses f64[c,6] blueprint x, y, heading, SLAM x, y, heading.
/// Metadata, all texts: format "cad2slam-projector", version "1.0" (readers refuse another major), model, scale,
/// weights, radius_m, outside, cell_size_m, lattice_{x_m,y_m,heading_rad}, {blueprint,slam}_{name,image_sha256,
/// resolution_m_per_px,width_px,height_px,origin_x_m,origin_y_m,origin_heading_rad}, quality_*, creator, created,
/// project, note; data_sha256 of the data section; header_sha256 of the header's JSON without that key, as compact text
/// with sorted keys (in Python json.dumps(header, sort_keys=True, separators=(",", ":"), ensure_ascii=False)).
/// Empty texts and unknown quality numbers are left out. Readers ignore metadata and arrays they do not know.
inline constexpr int kProjectorFormatMajor = 1;
inline constexpr int kProjectorFormatMinor = 0;

/// The bytes of a file; the same data gives the same bytes. Data that no reader would accept are refused here.
[[nodiscard]] Result<std::string> formatProjectorFile(const ProjectorData& data);
[[nodiscard]] Result<void> writeProjectorFile(const std::filesystem::path& path, const ProjectorData& data);

/// Everything in the file, checked: layout, sizes before allocation, SHA-256, finite numbers, indices, check poses.
[[nodiscard]] Result<ProjectorData> parseProjectorFile(std::string_view bytes, const std::string& file_name);
[[nodiscard]] Result<ProjectorData> readProjectorFile(const std::filesystem::path& path);

/// Only the function, with the same checks. This is what robots call. The file is read once, straight into
/// place, and closed; what another program does to it meanwhile can make it a damaged file, and nothing worse (a mapped
/// file that is cut would end the process).
[[nodiscard]] Result<Projector> loadProjector(const std::filesystem::path& path);
[[nodiscard]] Result<Projector> loadProjector(std::string_view bytes, const std::string& file_name);

}  // namespace cad2slam
