// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cad2slam/core/result.h"
#include "cad2slam/map/occupancy_grid.h"
#include "cad2slam/projection/projector.h"

#include <filesystem>
#include <functional>

namespace cad2slam {

/// Draws the blueprint pixel for pixel in the raster of the SLAM map and writes it as a map for robots: a YAML and a
/// PNG of the same name beside it. As `cad2slam-cli warp` does. Slow: from a worker. kCancelled: `is_stopped` said so
/// before anything was written.
[[nodiscard]] Result<void> writeBlueprintMap(const std::filesystem::path& yaml, const Projector& projector,
                                             const OccupancyGrid& blueprint, const MapFrame& slam_frame,
                                             const std::function<bool()>& is_stopped);

/// The PNG that belongs to the YAML.
[[nodiscard]] std::filesystem::path imageOfBlueprintMap(const std::filesystem::path& yaml);

}  // namespace cad2slam
