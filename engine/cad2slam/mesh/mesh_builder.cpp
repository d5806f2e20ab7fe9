// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/mesh/mesh_builder.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

namespace cad2slam {
namespace {

/// Tiles of `cell_px` pixels along one side of the raster; the last one is shifted inside the image.
struct TileSpans {
  int size_px;
  int cell_px;

  [[nodiscard]] int count() const { return (size_px + cell_px - 1) / cell_px; }
  [[nodiscard]] int begin(int tile) const { return std::max(0, std::min(tile * cell_px, size_px - cell_px)); }
  [[nodiscard]] int end(int tile) const { return std::min(size_px, begin(tile) + cell_px); }
};

}  // namespace

Result<Mesh> buildMesh(const OccupancyGrid& blueprint, std::optional<double> cell_size_m) {
  const MapFrame& frame = blueprint.frame();
  if (cell_size_m && !(std::isfinite(*cell_size_m) && *cell_size_m > 0.0)) {
    return fail(ErrorCode::kOutOfDomain, "the cell size must be a positive number of metres");
  }
  const double wanted_px = cell_size_m.value_or(automaticCellSize(blueprint)) / frame.resolution();
  const int cell_px = static_cast<int>(std::clamp(std::round(wanted_px), 1.0, 1e6));
  const TileSpans columns{frame.width(), cell_px};
  const TileSpans rows{frame.height(), cell_px};

  TileLattice lattice;
  lattice.cell_size = cell_px * frame.resolution();
  lattice.blueprint_from_lattice = {frame.metricFromPixel({0.0, 0.0}), frame.metricFromCorner().heading};

  std::vector<Eigen::Vector2d> centers;
  std::vector<TileCoordinate> tiles;
  for (int row = 0; row < rows.count(); ++row) {
    for (int column = 0; column < columns.count(); ++column) {
      const cv::Rect tile({columns.begin(column), rows.begin(row)}, cv::Point(columns.end(column), rows.end(row)));
      if (!blueprint.holdsFree(tile)) continue;
      if (tiles.size() == kMaxNodes) {
        std::ostringstream cell_size;
        cell_size << lattice.cell_size;
        return fail(ErrorCode::kOutOfDomain, "cells of " + cell_size.str() + " m give a mesh of more than " +
                                                 std::to_string(kMaxNodes) + " nodes; choose a larger cell size");
      }
      centers.push_back(frame.metricFromPixel(
          {0.5 * (columns.begin(column) + columns.end(column)), 0.5 * (rows.begin(row) + rows.end(row))}));
      tiles.push_back({column, -1 - row});
    }
  }
  if (tiles.empty())
    return fail(ErrorCode::kDegenerate, "the blueprint has no free pixel, so there is nothing to mesh");
  return Mesh::create(lattice, std::move(centers), std::move(tiles));
}

double automaticCellSize(const OccupancyGrid& blueprint, int node_budget) {
  const double resolution = blueprint.frame().resolution();
  const double free_area_m2 = static_cast<double>(blueprint.freePixels()) * resolution * resolution;
  return std::max(resolution, std::sqrt(free_area_m2 / std::max(1, node_budget)));
}

}  // namespace cad2slam
