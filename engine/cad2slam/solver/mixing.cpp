// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/solver/mixing.h"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "cad2slam/solver/global_fit.h"
#include "cad2slam/solver/node_blend.h"
#include "cad2slam/solver/residual_scores.h"

namespace cad2slam {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;

constexpr double kSmallestFactor = 0.05;  // of stretch; a plate that shrinks more is about to fold

using Residuals = std::vector<Vector2d>;

double scoreOfMixture(const Residuals& mesh, const Residuals& plate, double share) {
  std::vector<double> lengths;
  for (std::size_t i = 0; i < mesh.size(); ++i) lengths.push_back(((1.0 - share) * mesh[i] + share * plate[i]).norm());
  return cappedMean(std::move(lengths));
}

/// Of a node, `share` of the way.
void moveTowards(const Pose2& pose, const Vector2d& stretch, double share, Pose2& node_pose, Vector2d& node_stretch) {
  node_pose.translation += share * (pose.translation - node_pose.translation);
  node_pose.heading = wrapAngle(node_pose.heading + share * wrapAngle(pose.heading - node_pose.heading));
  node_stretch += share * (stretch - node_stretch);
}

}  // namespace

/// The share with the smallest leave-one-out residuals. Few anchors say little about it, so the weight that the mean of
/// two independent measurements would have is preferred where it is larger and costs next to nothing; it fades out
/// where the plate is much worse. In steps: what is left of the tolerance of the solve does not show in the answer.
double plateShare(const AnchorList& anchors, const Solution& solution, const ThinPlateFit& plate) {
  Residuals mesh;
  for (std::size_t i = 0; i < anchors.size(); ++i) {
    if (anchors[i].enabled) mesh.push_back(solution.anchors[i].predicted_without - anchors[i].in_slam);
  }
  constexpr std::size_t kFewestAnchors = 20;
  constexpr int kSteps = 20;
  constexpr int kMost = 14;
  constexpr double kNextToNothing = 1.05;
  constexpr double kAsGood = 1.2;
  constexpr double kTooBad = 1.3;
  if (mesh.size() < kFewestAnchors) return 0.0;
  std::array<double, kSteps + 1> scores{};
  for (int k = 0; k <= kSteps; ++k)
    scores[k] = scoreOfMixture(mesh, plate.leaveOneOut(), static_cast<double>(k) / kSteps);
  const auto smallest = static_cast<int>(std::min_element(scores.begin(), scores.end()) - scores.begin());
  if (!(scores.front() > 0.0)) return 0.0;
  const double ratio = scores.back() / scores.front();
  const double faded = std::clamp((kTooBad - ratio) / (kTooBad - kAsGood), 0.0, 1.0) / (1.0 + ratio * ratio);
  int preferred = static_cast<int>(std::lround(kSteps * faded));
  while (preferred > 0 && scores[preferred] > kNextToNothing * scores.front()) --preferred;
  return static_cast<double>(std::min(kMost, std::max(smallest, preferred))) / kSteps;
}

PlateAtNodes atNodes(const ThinPlateFit& plate, const Mesh& mesh) {
  PlateAtNodes at;
  at.reserve(mesh.nodeCount());
  for (const Vector2d& center : mesh.centers()) at.push_back(plate.at(center));
  return at;
}

bool mixIn(const PlateAtNodes& plate, double share, const std::vector<NodeIndex>& nodes, Solution& solution) {
  std::vector<Pose2> node_slam = solution.node_slam;
  std::vector<Vector2d> node_stretch = solution.node_stretch;
  for (const NodeIndex node : nodes) {
    const auto& [place, jacobian] = plate[node];
    const Matrix2d linear = jacobian / solution.global_fit.scale;
    const double heading = std::atan2(linear(1, 0) - linear(0, 1), linear(0, 0) + linear(1, 1));
    const Vector2d factors = (rotationMatrix(-heading) * linear).diagonal();
    if (!(linear.determinant() > 0.0) || !(factors.minCoeff() > kSmallestFactor)) return false;
    moveTowards({place, heading}, factors.array().log(), share, node_slam[node], node_stretch[node]);
  }
  std::swap(solution.node_slam, node_slam);
  std::swap(solution.node_stretch, node_stretch);
  if (!solution.minimum) solution.minimum = {std::move(node_slam), std::move(node_stretch)};
  solution.plate_share = share;
  return true;
}

std::vector<Vector2d> similarityLeaveOneOut(const AnchorList& anchors, const ScaleSettings& scale) {
  AnchorList others = anchors;
  Residuals residuals;
  for (std::size_t i = 0; i < anchors.size(); ++i) {
    if (!anchors[i].enabled) continue;
    others[i].enabled = false;
    const Result<Similarity2> fit = fitGlobally(others, scale);
    others[i].enabled = true;
    if (!fit) return {};
    residuals.emplace_back(*fit * anchors[i].in_blueprint - anchors[i].in_slam);
  }
  return residuals;
}

double similarityShare(const Solution& solution, const Residuals& leave_one_out) {
  constexpr std::size_t kFewestAnchors = 4;
  constexpr double kSmallest = 0.05;
  if (leave_one_out.size() < kFewestAnchors) return 0.0;
  // Wrong anchors do not count, but only those that the loss gave up: a place that is merely missed when its anchor is
  // left out is where the map is bent.
  constexpr double kGivenUp = 0.5;
  double mesh_sum = 0.0;
  double similarity_sum = 0.0;
  std::size_t count = 0;
  auto residual = leave_one_out.begin();
  for (const AnchorFit& fit : solution.anchors) {
    if (!fit.used) continue;
    const double length = (residual++)->norm();
    if (fit.loss_weight < kGivenUp) continue;
    mesh_sum += fit.leave_one_out_m;
    similarity_sum += length;
    ++count;
  }
  if (!(similarity_sum < kNoise_m * static_cast<double>(count)) || !(mesh_sum > 0.0)) return 0.0;
  const double share = 1.0 / (1.0 + std::pow(similarity_sum / mesh_sum, 8.0));
  return share < kSmallest ? 0.0 : share;
}

void mixInSimilarity(double share, const Mesh& mesh, const std::vector<NodeIndex>& nodes, Solution& solution) {
  if (!solution.minimum) solution.minimum = {solution.node_slam, solution.node_stretch};
  for (const NodeIndex node : nodes) {
    moveTowards(solution.global_fit * Pose2{mesh.centers()[node], 0.0}, Vector2d::Zero(), share,
                solution.node_slam[node], solution.node_stretch[node]);
  }
  solution.similarity_share = share;
}

Vector2d blended(const Mesh& mesh, const Solution& solution, const Vector2d& point_in_blueprint) {
  const NodeBlend blend = smoothBlend(mesh, point_in_blueprint);
  Vector2d sum = Vector2d::Zero();
  for (std::size_t k = 0; k < blend.count; ++k) {
    const NodeIndex node = blend.nodes[k];
    const Vector2d stretched = solution.global_fit.scale * solution.node_stretch[node].array().exp() *
                               (point_in_blueprint - mesh.centers()[node]).array();
    sum += blend.weights[k] * (solution.node_slam[node] * stretched);
  }
  return sum;
}

}  // namespace cad2slam
