// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/mesh/mesh.h"

#include <algorithm>
#include <limits>
#include <map>
#include <tuple>
#include <utility>

#include <Eigen/Geometry>

namespace cad2slam {
namespace {

std::pair<std::vector<std::uint32_t>, std::size_t> connectedComponents(std::size_t node_count,
                                                                       const std::vector<MeshEdge>& edges) {
  std::vector<std::uint32_t> parent(node_count);
  for (std::size_t i = 0; i < node_count; ++i) parent[i] = static_cast<std::uint32_t>(i);
  const auto root = [&parent](std::uint32_t node) {
    while (parent[node] != node) node = parent[node] = parent[parent[node]];
    return node;
  };
  for (const MeshEdge& edge : edges) {
    const std::uint32_t a = root(edge.from);
    const std::uint32_t b = root(edge.to);
    if (a != b) parent[std::max(a, b)] = std::min(a, b);
  }
  std::vector<std::uint32_t> components(node_count);
  std::size_t count = 0;
  // The root of a component is its first node, so it is numbered before any other node asks for its number.
  for (std::uint32_t i = 0; i < node_count; ++i) {
    const std::uint32_t first = root(i);
    components[i] = first == i ? static_cast<std::uint32_t>(count++) : components[first];
  }
  return {std::move(components), count};
}

}  // namespace

Result<Mesh> Mesh::create(const TileLattice& lattice, std::vector<Eigen::Vector2d> centers,
                          std::vector<TileCoordinate> tiles) {
  if (!(lattice.cell_size > 0.0) || !std::isfinite(lattice.cell_size) || !lattice.blueprint_from_lattice.isFinite()) {
    return fail(ErrorCode::kMalformed, "the mesh needs a finite, positive cell size and a finite origin");
  }
  if (tiles.empty()) return fail(ErrorCode::kDegenerate, "the mesh has no node");
  if (centers.size() != tiles.size()) {
    return fail(ErrorCode::kMalformed, "the mesh has " + std::to_string(centers.size()) + " centres for " +
                                           std::to_string(tiles.size()) + " tiles");
  }
  for (const Eigen::Vector2d& center : centers) {
    if (!center.allFinite()) return fail(ErrorCode::kMalformed, "the mesh has a node at no finite place");
  }
  std::optional<TileIndex> index = TileIndex::create(lattice, tiles.data(), tiles.size());
  if (!index) return fail(ErrorCode::kMalformed, "the mesh has two nodes on one tile");

  Mesh mesh;
  mesh.index_ = std::move(*index);
  mesh.centers_ = std::move(centers);
  mesh.tiles_ = std::move(tiles);
  mesh.edges_.reserve(2 * mesh.tiles_.size());
  for (NodeIndex node = 0; node < mesh.tiles_.size(); ++node) {
    const TileCoordinate tile = mesh.tiles_[node];
    const NodeIndex right = mesh.index_.at(tile.column + 1, tile.row);
    const NodeIndex up = mesh.index_.at(tile.column, tile.row + 1);
    if (right != TileIndex::kNone) mesh.edges_.push_back({node, right});
    if (up != TileIndex::kNone) mesh.edges_.push_back({node, up});
  }
  std::tie(mesh.components_, mesh.component_count_) = connectedComponents(mesh.tiles_.size(), mesh.edges_);
  return mesh;
}

NodeIndex Mesh::nearestNode(const Eigen::Vector2d& point_m) const {
  // Rings of tiles around the query; a ring at distance r holds no centre nearer than r - 1.5 cells, since the centre
  // of a shifted tile lies less than one cell off the middle of its tile.
  const Eigen::Vector2d cells = lattice().cellsFromBlueprint(point_m);
  NodeIndex best = 0;
  double best_squared = std::numeric_limits<double>::infinity();
  const auto consider = [&](NodeIndex node) {
    const double squared = (centers_[node] - point_m).squaredNorm();
    if (squared < best_squared || (squared == best_squared && node < best)) {
      best_squared = squared;
      best = node;
    }
  };
  constexpr double kTileLimit = 1e9;
  constexpr std::int32_t kRings = 24;
  if (std::abs(cells.x()) < kTileLimit && std::abs(cells.y()) < kTileLimit) {
    const auto column = static_cast<std::int32_t>(std::floor(cells.x()));
    const auto row = static_cast<std::int32_t>(std::floor(cells.y()));
    for (std::int32_t ring = 0; ring <= kRings; ++ring) {
      const double nearest_possible = (ring - 1.5) * lattice().cell_size;
      if (nearest_possible > 0.0 && nearest_possible * nearest_possible > best_squared) return best;
      for (std::int32_t dy = -ring; dy <= ring; ++dy) {
        const std::int32_t step = std::abs(dy) == ring ? 1 : std::max(1, 2 * ring);
        for (std::int32_t dx = -ring; dx <= ring; dx += step) {
          const NodeIndex node = index_.at(column + dx, row + dy);
          if (node != TileIndex::kNone) consider(node);
        }
      }
    }
  }
  for (NodeIndex node = 0; node < centers_.size(); ++node) consider(node);
  return best;
}

double Mesh::diagonal() const {
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector2d& center : centers_) box.extend(center);
  return box.diagonal().norm();
}

Mesh coarsened(const Mesh& mesh, int factor) {
  const auto floorDivided = [factor](std::int32_t tile) {
    return tile >= 0 ? tile / factor : -((-tile + factor - 1) / factor);
  };
  TileLattice lattice = mesh.lattice();
  lattice.cell_size *= factor;
  std::map<std::pair<std::int32_t, std::int32_t>, std::pair<Eigen::Vector2d, int>> sums;
  for (NodeIndex node = 0; node < mesh.nodeCount(); ++node) {
    const TileCoordinate tile = mesh.tiles()[node];
    auto& [sum, count] =
        sums.try_emplace({floorDivided(tile.row), floorDivided(tile.column)}, Eigen::Vector2d::Zero(), 0).first->second;
    sum += mesh.centers()[node];
    ++count;
  }
  std::vector<Eigen::Vector2d> centers;
  std::vector<TileCoordinate> tiles;
  for (const auto& [tile, sum] : sums) {
    tiles.push_back({tile.second, tile.first});
    centers.push_back(sum.first / sum.second);
  }
  Result<Mesh> coarse = Mesh::create(lattice, std::move(centers), std::move(tiles));
  return std::move(*coarse);  // tiles of a valid mesh, each once: cannot fail
}

}  // namespace cad2slam
