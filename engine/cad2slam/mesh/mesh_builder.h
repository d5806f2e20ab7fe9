// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "cad2slam/core/result.h"
#include "cad2slam/map/occupancy_grid.h"
#include "cad2slam/mesh/mesh.h"

namespace cad2slam {

/// Lays square tiles over a blueprint and makes a node of each tile that holds at least one free pixel (paper III-B).
/// `cell_size_m`: wanted edge length of a tile [m], rounded to whole pixels; empty picks one with automaticCellSize().
/// Tile k covers pixels [k*c, (k+1)*c) from the left and from the top; the last column and row are shifted inside the
/// image, and so are the centres of their nodes.
/// kOutOfDomain: a cell size that is not finite and positive, or so small that the mesh would exceed kMaxNodes.
/// kDegenerate: the blueprint has no free pixel.
[[nodiscard]] Result<Mesh> buildMesh(const OccupancyGrid& blueprint, std::optional<double> cell_size_m);

/// The cell size [m] that covers the free space of a blueprint with about `node_budget` tiles.
[[nodiscard]] double automaticCellSize(const OccupancyGrid& blueprint, int node_budget = 3000);

inline constexpr std::size_t kMaxNodes = 4'000'000;

}  // namespace cad2slam
