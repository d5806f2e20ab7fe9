// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/exports/triangulation.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace cad2slam {
namespace {

using Eigen::Vector2d;
using Block = std::pair<std::int64_t, std::int64_t>;  // column, row

std::set<Block> blocksOf(const Projector& projector, std::int64_t tiles_per_block) {
  const TileLattice& lattice = projector.info().lattice;
  std::set<Block> blocks;
  const auto blockOf = [tiles_per_block](double cell) {
    return static_cast<std::int64_t>(std::floor(cell / static_cast<double>(tiles_per_block)));
  };
  for (const Vector2d& middle : projector.tileMiddles()) {
    const Vector2d cells = lattice.cellsFromBlueprint(middle);
    blocks.emplace(blockOf(cells.x()), blockOf(cells.y()));
  }
  return blocks;
}

std::size_t cornerCount(const std::set<Block>& blocks) {
  std::set<Block> corners;
  for (const auto& [column, row] : blocks) {
    for (const std::int64_t dy : {0, 1}) {
      for (const std::int64_t dx : {0, 1}) corners.emplace(column + dx, row + dy);
    }
  }
  return corners.size();
}

double doubledArea(const Vector2d& a, const Vector2d& b, const Vector2d& c) {
  const Vector2d u = b - a;
  const Vector2d v = c - a;
  return u.x() * v.y() - u.y() * v.x();
}

/// Largest distance between both functions at some places of a triangle that lie on the mesh.
double deviationOn(const Projector& projector, const PointPair& a, const PointPair& b, const PointPair& c) {
  constexpr int kSteps = 6;
  double largest = 0.0;
  for (int i = 0; i <= kSteps; ++i) {
    for (int j = 0; i + j <= kSteps; ++j) {
      const double u = static_cast<double>(i) / kSteps;
      const double v = static_cast<double>(j) / kSteps;
      const Vector2d place = a.source + u * (b.source - a.source) + v * (c.source - a.source);
      const Projection exact = projector.slamFromBlueprint({place, 0.0}, OutsidePolicy::kError);
      if (!exact.ok()) continue;
      const Vector2d linear = a.target + u * (b.target - a.target) + v * (c.target - a.target);
      largest = std::max(largest, (linear - exact.pose.translation).norm());
    }
  }
  return largest;
}

}  // namespace

Result<TriangleMesh> triangulate(const Projector& projector, std::size_t most_vertices) {
  if (most_vertices < 4) return fail(ErrorCode::kOutOfDomain, "triangles need at least four vertices");
  const TileLattice& lattice = projector.info().lattice;
  std::int64_t tiles_per_block = 1;
  std::set<Block> blocks = blocksOf(projector, 1);
  while (cornerCount(blocks) > most_vertices) blocks = blocksOf(projector, ++tiles_per_block);

  TriangleMesh mesh;
  mesh.edge_m = lattice.cell_size * static_cast<double>(tiles_per_block);
  std::map<Block, std::uint32_t> vertices;
  const auto vertexAt = [&](std::int64_t column, std::int64_t row) {
    const auto [place, added] = vertices.emplace(Block(column, row), static_cast<std::uint32_t>(mesh.vertices.size()));
    if (added) {
      const Vector2d cells =
          Vector2d(static_cast<double>(column), static_cast<double>(row)) * static_cast<double>(tiles_per_block);
      const Vector2d corner = lattice.blueprintFromCells(cells);
      const Projection image = projector.slamFromBlueprint({corner, 0.0}, OutsidePolicy::kRigid);
      mesh.vertices.push_back({corner, image.pose.translation});
    }
    return place->second;
  };
  for (const auto& [column, row] : blocks) {
    const std::array<std::uint32_t, 4> corners = {vertexAt(column, row), vertexAt(column + 1, row),
                                                  vertexAt(column + 1, row + 1), vertexAt(column, row + 1)};
    for (const std::array<std::size_t, 3>& pick : {std::array<std::size_t, 3>{0, 1, 2}, {0, 2, 3}}) {
      const std::array<std::uint32_t, 3> triangle = {corners[pick[0]], corners[pick[1]], corners[pick[2]]};
      const PointPair& a = mesh.vertices[triangle[0]];
      const PointPair& b = mesh.vertices[triangle[1]];
      const PointPair& c = mesh.vertices[triangle[2]];
      if (!(doubledArea(a.target, b.target, c.target) > 0.0)) {
        return fail(ErrorCode::kOutOfDomain, "the mesh folds near (" + std::to_string(a.source.x()) + ", " +
                                                 std::to_string(a.source.y()) +
                                                 ") of the blueprint, so it has no inverse as triangles");
      }
      mesh.max_deviation_m = std::max(mesh.max_deviation_m, deviationOn(projector, a, b, c));
      mesh.triangles.push_back(triangle);
    }
  }
  return mesh;
}

}  // namespace cad2slam
