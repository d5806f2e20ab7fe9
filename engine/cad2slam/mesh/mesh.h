// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <vector>

#include "cad2slam/core/result.h"
#include "cad2slam/mesh/tile_index.h"
#include "cad2slam/mesh/tile_lattice.h"

namespace cad2slam {

using NodeIndex = std::uint32_t;

/// Two 4-neighbours of the tile lattice; `from` is the left or the lower one.
struct MeshEdge {
  NodeIndex from = 0;
  NodeIndex to = 0;
};

/// The mesh at rest over the free space of a blueprint: one node for each tile that holds free space, one edge for
/// each pair of 4-neighbours (paper III-B). Immutable. Node order is deterministic: top row first, left to right.
class Mesh {
 public:
  /// `centers` [m] in the blueprint frame and `tiles` belong together. kMalformed: sizes differ, a tile stands twice,
  /// a centre is not finite or the lattice has no positive cell size; kDegenerate: no tile at all.
  [[nodiscard]] static Result<Mesh> create(const TileLattice& lattice, std::vector<Eigen::Vector2d> centers,
                                           std::vector<TileCoordinate> tiles);

  [[nodiscard]] std::size_t nodeCount() const { return centers_.size(); }
  [[nodiscard]] const TileLattice& lattice() const { return index_.lattice(); }
  [[nodiscard]] const std::vector<Eigen::Vector2d>& centers() const { return centers_; }  ///< [m], blueprint frame
  [[nodiscard]] const std::vector<TileCoordinate>& tiles() const { return tiles_; }
  [[nodiscard]] const std::vector<MeshEdge>& edges() const { return edges_; }
  [[nodiscard]] const TileIndex& index() const { return index_; }

  /// Connected component of each node, 0-based, numbered in order of their first node.
  [[nodiscard]] const std::vector<std::uint32_t>& components() const { return components_; }
  [[nodiscard]] std::size_t componentCount() const { return component_count_; }

  /// The node whose centre is nearest to a point of the blueprint frame [m]; the lower index wins a tie.
  [[nodiscard]] NodeIndex nearestNode(const Eigen::Vector2d& point_m) const;

  /// Length of the diagonal of the bounding box of all centres [m].
  [[nodiscard]] double diagonal() const;

 private:
  Mesh() = default;

  std::vector<Eigen::Vector2d> centers_;
  std::vector<TileCoordinate> tiles_;
  std::vector<MeshEdge> edges_;
  std::vector<std::uint32_t> components_;
  std::size_t component_count_ = 0;
  TileIndex index_;
};

/// A mesh on tiles `factor` times as large; a node lies at the mean of the centres it stands for.
[[nodiscard]] Mesh coarsened(const Mesh& mesh, int factor);

}  // namespace cad2slam
