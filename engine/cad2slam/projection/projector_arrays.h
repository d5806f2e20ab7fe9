// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "cad2slam/core/large_vector.h"
#include "cad2slam/projection/projector_data.h"

namespace cad2slam {

/// Nodes of a projector as they lie in a file, one row each.
struct ProjectorArrays {
  LargeVector<std::array<double, 2>> node_blueprint;  ///< x, y [m]
  LargeVector<std::array<double, 3>> node_slam;       ///< x, y [m], heading [rad]
  LargeVector<std::array<double, 2>> node_stretch;    ///< log-stretch along the node's axes
  LargeVector<TileCoordinate> node_tile;
};

[[nodiscard]] ProjectorArrays arraysOf(const ProjectorData& data);
/// The other way; everything else of `data` stays as it is.
void setNodes(ProjectorData& data, const ProjectorArrays& arrays);

}  // namespace cad2slam
