// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "cad2slam/core/result.h"
#include "cad2slam/simulation/true_warp.h"

namespace cad2slam {

/// A true warp on disk: a YAML with `grid` (a NumPy file beside it, float32 [rows, columns, 3]: x, y, heading in the
/// SLAM frame), `origin: [x, y]` (blueprint place of entry [0, 0]) and `step`, metres. Rows grow with y; NaN where
/// there is no building.
[[nodiscard]] Result<TrueWarp> readTrueWarp(const std::filesystem::path& yaml);
/// Writes the YAML and the `.npy` of the same name beside it.
[[nodiscard]] Result<void> writeTrueWarp(const std::filesystem::path& yaml, const TrueWarp& warp);

}  // namespace cad2slam
