// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "cad2slam/core/result.h"
#include "cad2slam/exports/feature.h"
#include "cad2slam/exports/level_transform.h"
#include "cad2slam/exports/pose_grid.h"
#include "cad2slam/exports/triangle_mesh.h"
#include "cad2slam/projection/projector_data.h"

namespace cad2slam {

/// Texts and bytes that other programs read. Numbers in the shortest form that reads back exactly.

/// For the configuration of an Open-RMF fleet adapter: `reference_coordinates` for adapters that fit by themselves and
/// `rmf_fleet: transforms:` for those that take numbers, with the residuals as comments.
[[nodiscard]] std::string formatRmfTransform(const LevelTransform& transform, const std::string& level);

/// nav2's RViz panel: points become waypoints, in order. kOutOfDomain: no point.
[[nodiscard]] Result<std::string> formatNav2Waypoints(const FeatureList& features);

/// PROJ's `+proj=tinshift +file=...`, format version 1.0: outside the triangles there is an error.
[[nodiscard]] std::string formatTinshift(const TriangleMesh& mesh, const std::string& name);

/// The graph for g2o: VERTEX_SE2 for the nodes at their solved poses, EDGE_SE2 with the rest offsets between them, and
/// for each anchor a fixed VERTEX_XY and an EDGE_SE2_XY from the nearest node (paper eq. 3 and 4 with weights 1, 10, 10
/// and 100). Stretch is left out: g2o has no such vertex.
[[nodiscard]] std::string formatG2o(const ProjectorData& data);

/// NumPy's .npy of a grid, float64 [rows, columns, 3] of x, y, heading.
[[nodiscard]] std::string formatNpy(const PoseGrid& grid);
/// What a reader of the .npy needs besides: JSON.
[[nodiscard]] std::string formatGridDescription(const PoseGrid& grid, const std::string& npy_name,
                                                const std::string& source_frame, const std::string& target_frame);

}  // namespace cad2slam
