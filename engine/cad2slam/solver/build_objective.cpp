// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/solver/build_objective.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "cad2slam/geometry/angle.h"

namespace cad2slam {
namespace {

/// What ties a component to the mesh's anchors.
struct ComponentAnchors {
  std::size_t count = 0;
  std::size_t nodes = 0;
  Eigen::Vector2d first = Eigen::Vector2d::Zero();
  double spread_m = 0.0;
};

/// Weight of the whole heading prior of a component whose anchors leave its heading open [m^2 of anchor information]:
/// weak against any anchor, strong against rounding.
constexpr double kHeadingPrior = 1e-2;

NodeBlend blendFor(const Mesh& mesh, Model model, const Eigen::Vector2d& in_blueprint) {
  return model == Model::kRigid ? nearestNodeBlend(mesh, in_blueprint) : smoothBlend(mesh, in_blueprint);
}

EdgeTerm makeEdgeTerm(const Mesh& mesh, const MeshEdge& edge, const std::vector<std::uint32_t>& active_number,
                      const SolverSettings& settings, double scale) {
  EdgeTerm term;
  term.from = active_number[edge.from];
  term.to = active_number[edge.to];
  term.rest = scale * (mesh.centers()[edge.to] - mesh.centers()[edge.from]);
  const Eigen::Vector2d along = term.rest.normalized();
  term.whitener.row(0) = std::sqrt(settings.lambda_x) * along.transpose();
  term.whitener.row(1) = std::sqrt(settings.lambda_y) * Eigen::RowVector2d(-along.y(), along.x());
  return term;
}

}  // namespace

SolverSettings withAutomaticWeights(const SolverSettings& settings, const Mesh& mesh, double scale) {
  const double theta_length_m =
      settings.stiffness == Stiffness::kSmooth || settings.stiffness == Stiffness::kLoose ? 0.6 : 1.5;
  SolverSettings filled = settings;
  if (!filled.lambda_theta) filled.lambda_theta = theta_length_m * scale * mesh.diagonal();
  return filled;
}

AnchorTerm makeAnchorTerm(const Mesh& mesh, const NodeBlend& blend, const Eigen::Vector2d& in_blueprint,
                          const Eigen::Vector2d& in_slam, double scale) {
  AnchorTerm term;
  term.blend = blend;
  term.target = in_slam;
  for (std::size_t k = 0; k < blend.count; ++k) {
    term.offsets[k] = scale * (in_blueprint - mesh.centers()[blend.nodes[k]]);
  }
  return term;
}

std::vector<std::uint32_t> activeNumbers(const Objective& objective, std::size_t node_count) {
  std::vector<std::uint32_t> numbers(node_count, kInactive);
  for (std::uint32_t k = 0; k < objective.active_nodes.size(); ++k) numbers[objective.active_nodes[k]] = k;
  return numbers;
}

Objective buildObjective(const Mesh& mesh, const AnchorList& anchors, const SolverSettings& settings,
                         const Similarity2& global_fit) {
  Objective objective;
  objective.unknowns = settings.model == Model::kStretch ? kStretchUnknowns : kRigidUnknowns;
  objective.sqrt_lambda_theta = std::sqrt(settings.lambda_theta.value_or(0.0));
  objective.sqrt_lambda_stretch = std::sqrt(settings.lambda_stretch);
  objective.anchor_information = settings.anchor_information;
  objective.loss_width_m = settings.loss_width_m.value_or(0.0);
  objective.prior_heading = global_fit.heading;

  std::vector<ComponentAnchors> components(mesh.componentCount());
  for (const Anchor& anchor : anchors) {
    if (!anchor.enabled) continue;
    const NodeBlend blend = blendFor(mesh, settings.model, anchor.in_blueprint);
    objective.anchors.push_back(makeAnchorTerm(mesh, blend, anchor.in_blueprint, anchor.in_slam, global_fit.scale));
    std::uint32_t last_component = kInactive;
    for (std::size_t k = 0; k < blend.count; ++k) {
      const std::uint32_t component = mesh.components()[blend.nodes[k]];
      if (component == last_component) continue;
      last_component = component;
      ComponentAnchors& held = components[component];
      if (held.count++ == 0) held.first = anchor.in_blueprint;
      held.spread_m = std::max(held.spread_m, (anchor.in_blueprint - held.first).norm());
    }
  }
  const double cell_area_m2 = std::pow(global_fit.scale * mesh.lattice().cell_size, 2);
  const auto used = static_cast<double>(std::max<std::size_t>(1, objective.anchors.size()));
  objective.sqrt_prior = std::sqrt(settings.prior_strength / used * cell_area_m2);

  for (NodeIndex node = 0; node < mesh.nodeCount(); ++node) {
    ComponentAnchors& component = components[mesh.components()[node]];
    ++component.nodes;
    if (component.count > 0) objective.active_nodes.push_back(node);
  }
  for (const NodeIndex node : objective.active_nodes) {
    const ComponentAnchors& component = components[mesh.components()[node]];
    const bool heading_is_open = component.spread_m < 0.5 * mesh.lattice().cell_size;
    objective.heading_prior.push_back(
        heading_is_open ? std::sqrt(kHeadingPrior * settings.anchor_information / static_cast<double>(component.nodes))
                        : 0.0);
  }
  const std::vector<std::uint32_t> active_number = activeNumbers(objective, mesh.nodeCount());
  for (const MeshEdge& edge : mesh.edges()) {
    if (active_number[edge.from] == kInactive) continue;
    objective.edges.push_back(makeEdgeTerm(mesh, edge, active_number, settings, global_fit.scale));
  }
  for (AnchorTerm& anchor : objective.anchors) {
    for (std::size_t k = 0; k < anchor.blend.count; ++k) anchor.blend.nodes[k] = active_number[anchor.blend.nodes[k]];
  }
  return objective;
}

Eigen::VectorXd startingPoint(const Objective& objective, const Mesh& mesh, const Similarity2& global_fit,
                              const Solution* warm_start) {
  const bool warm =
      warm_start != nullptr && warm_start->node_slam.size() == mesh.nodeCount() &&
      warm_start->settings.model == (objective.unknowns == kStretchUnknowns ? Model::kStretch : Model::kRigid);
  // What was mixed in lies beside the minimum: from there it would be a longer way to the next one.
  const bool is_mixed = warm && warm_start->minimum;
  Eigen::VectorXd x(static_cast<Eigen::Index>(objective.size()));
  for (std::size_t k = 0; k < objective.nodeCount(); ++k) {
    const NodeIndex node = objective.active_nodes[k];
    double* unknowns = x.data() + k * static_cast<std::size_t>(objective.unknowns);
    const Pose2 pose = is_mixed ? warm_start->minimum->slam[node]
                       : warm   ? warm_start->node_slam[node]
                                : global_fit * Pose2{mesh.centers()[node], 0.0};
    unknowns[0] = pose.translation.x();
    unknowns[1] = pose.translation.y();
    unknowns[2] = pose.heading;
    if (objective.unknowns != kStretchUnknowns) continue;
    const Eigen::Vector2d stretch = is_mixed ? warm_start->minimum->stretch[node]
                                    : warm   ? warm_start->node_stretch[node]
                                             : Eigen::Vector2d::Zero();
    unknowns[3] = stretch.x();
    unknowns[4] = stretch.y();
  }
  return x;
}

}  // namespace cad2slam
