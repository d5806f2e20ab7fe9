// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include <cmath>
#include <cstdint>
#include <functional>

#include "cad2slam/geometry/pose2.h"

namespace cad2slam {

/// Column and row of a tile; the column grows along the x axis of the lattice, the row along its y axis.
struct TileCoordinate {
  std::int32_t column = 0;
  std::int32_t row = 0;

  friend bool operator==(const TileCoordinate& a, const TileCoordinate& b) {
    return a.column == b.column && a.row == b.row;
  }
  friend bool operator!=(const TileCoordinate& a, const TileCoordinate& b) { return !(a == b); }
};

/// The square tiles over a blueprint. Tile (column, row) covers [column, column+1) x [row, row+1) cells, measured from
/// `blueprint_from_lattice`. A mesh puts that origin on the top-left corner of the raster, so its rows are negative.
struct TileLattice {
  double cell_size = 1.0;        ///< [m], > 0
  Pose2 blueprint_from_lattice;  ///< pose of the lattice in the blueprint frame, metres and radians

  /// Continuous tile coordinates [cells] of a point in the blueprint frame [m].
  [[nodiscard]] Eigen::Vector2d cellsFromBlueprint(const Eigen::Vector2d& point_m) const {
    return blueprint_from_lattice.inverse() * point_m / cell_size;
  }
  [[nodiscard]] Eigen::Vector2d blueprintFromCells(const Eigen::Vector2d& cells) const {
    return blueprint_from_lattice * Eigen::Vector2d(cells * cell_size);
  }
};

}  // namespace cad2slam
