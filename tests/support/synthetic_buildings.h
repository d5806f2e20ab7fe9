// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include "cad2slam/anchors/anchor.h"
#include "cad2slam/map/occupancy_grid.h"
#include "cad2slam/mesh/mesh_builder.h"

namespace cad2slam::testing {

/// A raster where `is_free(column, row)` decides between free and occupied.
template <class IsFree>
OccupancyGrid drawGrid(const MapFrame& frame, const IsFree& is_free) {
  cv::Mat states(frame.height(), frame.width(), CV_8UC1);
  for (int row = 0; row < states.rows; ++row) {
    for (int column = 0; column < states.cols; ++column) {
      const CellState state = is_free(column, row) ? CellState::kFree : CellState::kOccupied;
      states.at<std::uint8_t>(row, column) = static_cast<std::uint8_t>(state);
    }
  }
  return {frame, states};
}

/// A U-shaped corridor, 20 x 12 m at 0.1 m/px, 3 m wide; origin off zero.
inline OccupancyGrid uShapedCorridor() {
  const MapFrame frame = *MapFrame::create(0.1, 200, 120, {{-3.0, 2.0}, 0.0});
  return drawGrid(frame, [](int column, int row) {
    const bool left = column < 30;
    const bool right = column >= 170;
    const bool bottom = row >= 90;
    return left || right || bottom;
  });
}

inline std::shared_ptr<const Mesh> meshOf(const OccupancyGrid& grid, double cell_size_m) {
  return std::make_shared<const Mesh>(*buildMesh(grid, cell_size_m));
}

/// Three rooms of 6 x 6 m with walls of 2 m between them.
inline std::shared_ptr<const Mesh> threeRooms() {
  const MapFrame frame = *MapFrame::create(0.1, 220, 60, {{0.0, 0.0}, 0.0});
  return meshOf(drawGrid(frame, [](int column, int) { return column % 80 < 60; }), 1.0);
}

/// Four anchors in the first of the three rooms, one in the second, two in the third.
template <class Warp>
AnchorList fewAnchorsInThreeRooms(const Warp& slam_from_blueprint) {
  AnchorList anchors;
  const auto add = [&](const Eigen::Vector2d& place) {
    anchors.push_back({static_cast<AnchorId>(anchors.size() + 1), place, slam_from_blueprint(place), true, {}, {}});
  };
  for (int k = 0; k < 4; ++k) add({0.8 + 1.2 * k, 0.5 + (k % 3) * 2.4});
  for (const Eigen::Vector2d& place : {Eigen::Vector2d(11.0, 3.0), {17.0, 1.0}, {21.0, 5.0}}) add(place);
  return anchors;
}

/// Anchors at random nodes of a mesh, put into the SLAM map by `slam_from_blueprint`.
template <class Warp>
AnchorList anchorsAt(const Mesh& mesh, std::size_t count, unsigned seed, const Warp& slam_from_blueprint) {
  std::mt19937 random(seed);
  AnchorList anchors;
  for (std::size_t k = 0; k < count; ++k) {
    const double part = std::generate_canonical<double, 53>(random);
    const auto node = static_cast<std::size_t>(part * static_cast<double>(mesh.nodeCount()));
    Anchor anchor;
    anchor.id = static_cast<AnchorId>(k + 1);
    anchor.in_blueprint = mesh.centers()[node] + Eigen::Vector2d(0.11, -0.07);
    anchor.in_slam = slam_from_blueprint(anchor.in_blueprint);
    anchors.push_back(anchor);
  }
  return anchors;
}

/// A place chosen evenly over the tiles of a mesh.
inline Eigen::Vector2d randomPlace(const Mesh& mesh, std::mt19937& random) {
  std::uniform_real_distribution<double> part(0.0, 1.0);
  const auto node = static_cast<std::size_t>(part(random) * static_cast<double>(mesh.nodeCount()));
  const TileCoordinate tile = mesh.tiles()[node];
  return mesh.lattice().blueprintFromCells({tile.column + part(random), tile.row + part(random)});
}

}  // namespace cad2slam::testing
