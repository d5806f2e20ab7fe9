// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/solver/node_blend.h"

#include <cmath>

namespace cad2slam {
namespace {

std::array<double, 3> splineWeights(double fraction) {
  return {0.5 * (1.0 - fraction) * (1.0 - fraction), 0.75 - (fraction - 0.5) * (fraction - 0.5),
          0.5 * fraction * fraction};
}

}  // namespace

NodeBlend nearestNodeBlend(const Mesh& mesh, const Eigen::Vector2d& point_in_blueprint) {
  NodeBlend blend;
  blend.nodes[0] = mesh.nearestNode(point_in_blueprint);
  blend.weights[0] = 1.0;
  blend.count = 1;
  return blend;
}

NodeBlend smoothBlend(const Mesh& mesh, const Eigen::Vector2d& point_in_blueprint) {
  const Eigen::Vector2d cells = mesh.lattice().cellsFromBlueprint(point_in_blueprint);
  const TileCoordinate tile = mesh.index().nearestTile(cells);
  const Eigen::Vector2d inner = (cells - Eigen::Vector2d(tile.column, tile.row)).cwiseMax(0.0).cwiseMin(1.0 - 1e-10);
  const std::array<double, 3> across = splineWeights(inner.x());
  const std::array<double, 3> up = splineWeights(inner.y());
  const std::array<std::uint32_t, 9> around = mesh.index().neighbourhood(tile.column, tile.row);
  NodeBlend blend;
  double total = 0.0;
  for (std::size_t k = 0; k < around.size(); ++k) {
    if (around[k] == TileIndex::kNone) continue;
    blend.nodes[blend.count] = around[k];
    blend.weights[blend.count] = across[k % 3] * up[k / 3];
    total += blend.weights[blend.count++];
  }
  for (std::size_t k = 0; k < blend.count; ++k) blend.weights[k] /= total;
  return blend;
}

}  // namespace cad2slam
