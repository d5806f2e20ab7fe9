// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/main_window/mesh_overlay.h"

#include "ui/convert.h"
#include "ui/views/mesh_layer.h"

#include <utility>

namespace cad2slam {
namespace {

MeshOverlay edgesWithStrain(const SolveResult& result) {
  MeshOverlay overlay;
  const auto& rest = result.mesh->centers();
  const auto& solved = result.solution.node_slam;
  const double scale = result.solution.global_fit.scale;
  overlay.edges.reserve(result.mesh->edges().size());
  overlay.strain.reserve(result.mesh->edges().size());
  for (const MeshEdge& edge : result.mesh->edges()) {
    overlay.edges.push_back({edge.from, edge.to});
    const double rest_length = scale * (rest[edge.to] - rest[edge.from]).norm();
    const double length = (solved[edge.to].translation - solved[edge.from].translation).norm();
    overlay.strain.push_back(static_cast<float>(length / rest_length - 1.0));
  }
  overlay.folds = result.folded_nodes;
  overlay.full_color_strain = fullColorStrain(overlay);  // here once; views, legends and workers ask for it again
  return overlay;
}

}  // namespace

std::shared_ptr<const MeshOverlay> meshInBlueprint(const SolveResult& result) {
  MeshOverlay overlay = edgesWithStrain(result);
  for (const Eigen::Vector2d& center : result.mesh->centers()) overlay.nodes_m.push_back(toQPointF(center));
  return std::make_shared<const MeshOverlay>(std::move(overlay));
}

std::shared_ptr<const MeshOverlay> meshInSlam(const SolveResult& result) {
  MeshOverlay overlay = edgesWithStrain(result);
  for (const Pose2& node : result.solution.node_slam) overlay.nodes_m.push_back(toQPointF(node.translation));
  return std::make_shared<const MeshOverlay>(std::move(overlay));
}

}  // namespace cad2slam
