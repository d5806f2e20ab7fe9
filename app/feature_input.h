// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "cad2slam/core/result.h"
#include "cad2slam/exports/feature_warp.h"

namespace cad2slam::cli {

/// The features of a file (GeoJSON or CSV) in the other frame. Warnings go to standard error; errors name the file.
[[nodiscard]] Result<WarpedFeatures> readWarpedFeatures(const std::string& file, const Projector& projector,
                                                        const FeatureWarpOptions& options);

}  // namespace cad2slam::cli
