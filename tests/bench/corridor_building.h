// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include "cad2slam/anchors/anchor.h"
#include "cad2slam/mesh/mesh.h"
#include "cad2slam/projection/projector_data.h"

namespace cad2slam::bench {

/// An office building of any size: a grid of corridors three tiles wide, with four rooms between them, each with doors.
inline bool isFreeTile(std::int32_t column, std::int32_t row) {
  const std::int32_t x = column % 24;
  const std::int32_t y = row % 20;
  if (x < 3 || y < 3) return true;
  if (x == 3 || x == 23) return y == 7 || y == 15;
  if (y == 3 || y == 19) return x == 8 || x == 18;
  return x != 13 && y != 11;
}

/// The first `nodes` free tiles of a square building.
inline std::vector<TileCoordinate> officeTiles(std::size_t nodes) {
  const auto side = static_cast<std::int32_t>(std::ceil(std::sqrt(static_cast<double>(nodes) / 0.8)));
  std::vector<TileCoordinate> tiles;
  tiles.reserve(nodes);
  for (std::int32_t row = 0; tiles.size() < nodes; ++row) {
    for (std::int32_t column = 0; column < side && tiles.size() < nodes; ++column) {
      if (isFreeTile(column, row)) tiles.push_back({column, row});
    }
  }
  return tiles;
}

inline Eigen::Vector2d centerOf(const TileCoordinate& tile, double cell_size_m) {
  return cell_size_m * Eigen::Vector2d(tile.column + 0.5, tile.row + 0.5);
}

inline std::shared_ptr<const Mesh> officeMesh(std::size_t nodes, double cell_size_m = 1.0) {
  std::vector<TileCoordinate> tiles = officeTiles(nodes);
  std::vector<Eigen::Vector2d> centers;
  for (const TileCoordinate& tile : tiles) centers.push_back(centerOf(tile, cell_size_m));
  TileLattice lattice;
  lattice.cell_size = cell_size_m;
  return std::make_shared<const Mesh>(*Mesh::create(lattice, std::move(centers), std::move(tiles)));
}

/// What a robot's map does to the building: turned, bent by some metres over its length, corridors a little shorter.
inline Pose2 warped(const Eigen::Vector2d& place, double extent_m) {
  const double bend = place.x() / extent_m;
  const Eigen::Vector2d drifted(0.98 * place.x(), place.y() + 0.03 * extent_m * bend * bend);
  return {rotationMatrix(2.5) * drifted, 2.5 + 0.06 * bend};
}

inline double extentOf(const std::vector<TileCoordinate>& tiles, double cell_size_m) {
  std::int32_t largest = 1;
  for (const TileCoordinate& tile : tiles) largest = std::max({largest, tile.column + 1, tile.row + 1});
  return cell_size_m * largest;
}

/// Anchors at random nodes, clicked with 3 cm of noise.
inline AnchorList officeAnchors(const Mesh& mesh, std::size_t count) {
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0.0, 0.03);
  const double extent_m = extentOf(mesh.tiles(), mesh.lattice().cell_size);
  AnchorList anchors;
  for (std::size_t k = 0; k < count; ++k) {
    const Eigen::Vector2d place = mesh.centers()[random() % mesh.nodeCount()];
    const Eigen::Vector2d click(noise(random), noise(random));
    anchors.push_back({static_cast<AnchorId>(k + 1), place, warped(place, extent_m).translation + click, true, {}, {}});
  }
  return anchors;
}

/// A projector over the building as if it had been solved.
inline ProjectorData officeProjector(std::size_t nodes, double cell_size_m = 1.0) {
  ProjectorData data;
  data.info.lattice.cell_size = cell_size_m;
  data.node_tile = officeTiles(nodes);
  const double extent_m = extentOf(data.node_tile, cell_size_m);
  for (const TileCoordinate& tile : data.node_tile) {
    data.node_blueprint.push_back(centerOf(tile, cell_size_m));
    data.node_slam.push_back(warped(data.node_blueprint.back(), extent_m));
    data.node_stretch.emplace_back(-0.01, 0.01);
  }
  return data;
}

}  // namespace cad2slam::bench
