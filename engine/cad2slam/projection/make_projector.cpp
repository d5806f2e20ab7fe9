// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/projection/make_projector.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

namespace cad2slam {
namespace {

constexpr std::size_t kCheckPoses = 16;

/// Poses spread evenly over the nodes, with headings all around, that have an answer in both directions.
std::vector<CheckPose> makeCheckPoses(const Mesh& mesh, const Projector& projector) {
  std::vector<CheckPose> poses;
  const std::size_t wanted = std::min(kCheckPoses, mesh.nodeCount());
  for (std::size_t k = 0; k < wanted; ++k) {
    const std::size_t node = (2 * k + 1) * mesh.nodeCount() / (2 * wanted);
    // The centre of a shifted tile may lie off its tile, so take the middle of the tile itself.
    const TileCoordinate tile = mesh.tiles()[node];
    const Eigen::Vector2d place = mesh.lattice().blueprintFromCells({tile.column + 0.5, tile.row + 0.5});
    const Pose2 in_blueprint{place, wrapAngle(2.399963 * static_cast<double>(k))};  // golden angle
    const Projection forward = projector.slamFromBlueprint(in_blueprint, OutsidePolicy::kError);
    if (forward.ok()) poses.push_back({in_blueprint, forward.pose});
  }
  return poses;
}

QualityInfo qualityOf(const Solution& solution) {
  QualityInfo quality;
  std::vector<double> leave_one_out;
  double squares = 0.0;
  for (const AnchorFit& fit : solution.anchors) {
    if (!fit.used) continue;
    squares += fit.residual_m * fit.residual_m;
    quality.anchor_max_m = std::max(quality.anchor_max_m, fit.residual_m);
    ++quality.anchors_used;
    if (std::isfinite(fit.leave_one_out_m)) leave_one_out.push_back(fit.leave_one_out_m);
  }
  if (quality.anchors_used > 0) quality.anchor_rms_m = std::sqrt(squares / static_cast<double>(quality.anchors_used));
  if (leave_one_out.empty()) return quality;
  std::sort(leave_one_out.begin(), leave_one_out.end());
  quality.leave_one_out_mean_m =
      std::accumulate(leave_one_out.begin(), leave_one_out.end(), 0.0) / static_cast<double>(leave_one_out.size());
  quality.leave_one_out_median_m = leave_one_out[leave_one_out.size() / 2];
  quality.leave_one_out_max_m = leave_one_out.back();
  return quality;
}

ProjectorData nodesOf(const Mesh& mesh, const Solution& solution, BlendWeights weights) {
  ProjectorData data;
  data.info.model = solution.settings.model == Model::kStretch ? "stretch" : "rigid";
  data.info.scale = solution.global_fit.scale;
  data.info.weights = weights;
  data.info.lattice = mesh.lattice();
  data.node_blueprint = mesh.centers();
  data.node_slam = solution.node_slam;
  data.node_stretch = solution.node_stretch;
  data.node_tile = mesh.tiles();
  return data;
}

}  // namespace

Result<Projector> makeProjector(const Mesh& mesh, const Solution& solution, BlendWeights weights) {
  return Projector::create(nodesOf(mesh, solution, weights));
}

Result<ProjectorData> makeProjectorData(const Mesh& mesh, const Solution& solution, const AnchorList& anchors,
                                        const ProjectorOptions& options) {
  ProjectorData data = nodesOf(mesh, solution, options.weights);
  data.info.radius_m = options.radius_m;
  data.info.outside = options.outside;
  data.info.blueprint = options.blueprint;
  data.info.slam = options.slam;
  data.info.creator = options.creator;
  data.info.created = options.created;
  data.info.project = options.project;
  data.info.note = options.note;
  data.edges.reserve(mesh.edges().size());
  for (const MeshEdge& edge : mesh.edges()) data.edges.push_back({edge.from, edge.to});
  for (const Anchor& anchor : anchors) {
    if (!anchor.enabled) continue;
    data.anchors.push_back({anchor.in_blueprint.x(), anchor.in_blueprint.y(), anchor.in_slam.x(), anchor.in_slam.y()});
  }
  const Result<Projector> projector = Projector::create(data);
  if (!projector) return failAs(projector);
  data.check_poses = makeCheckPoses(mesh, *projector);
  data.info.quality = qualityOf(solution);
  data.info.quality.folded_tiles = projector->foldedTileCount();
  return data;
}

}  // namespace cad2slam
