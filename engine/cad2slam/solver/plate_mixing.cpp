// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/solver/plate_mixing.h"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "cad2slam/solver/capped_mean.h"
#include "cad2slam/solver/node_blend.h"

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

}  // namespace

/// The share with the smallest leave-one-out residuals. Few anchors say little about it, so the weight that the mean of
/// two independent measurements would have is preferred where it is larger and costs next to nothing; it fades out
/// where the plate is much worse. In steps: what is left of the tolerance of the solve does not show in the answer.
double plateShare(const AnchorList& anchors, const Solution& solution, const ThinPlateFit& plate) {
  Residuals mesh;
  for (std::size_t i = 0; i < anchors.size(); ++i) {
    if (anchors[i].enabled) mesh.push_back(solution.anchors[i].predicted_without - anchors[i].in_slam);
  }
  constexpr int kSteps = 20;
  constexpr double kNextToNothing = 1.05;
  constexpr double kAsGood = 1.2;
  constexpr double kTooBad = 1.3;
  std::array<double, kSteps + 1> scores{};
  for (int k = 0; k <= kSteps; ++k)
    scores[k] = scoreOfMixture(mesh, plate.leaveOneOut(), static_cast<double>(k) / kSteps);
  const auto smallest = static_cast<int>(std::min_element(scores.begin(), scores.end()) - scores.begin());
  if (!(scores.front() > 0.0)) return 0.0;
  const double ratio = scores.back() / scores.front();
  const double faded = std::clamp((kTooBad - ratio) / (kTooBad - kAsGood), 0.0, 1.0) / (1.0 + ratio * ratio);
  int preferred = static_cast<int>(std::lround(kSteps * faded));
  while (preferred > 0 && scores[preferred] > kNextToNothing * scores.front()) --preferred;
  return static_cast<double>(std::max(smallest, preferred)) / kSteps;
}

bool mixIn(const ThinPlateFit& plate, double share, const Mesh& mesh, const std::vector<NodeIndex>& nodes,
           Solution& solution) {
  std::vector<Pose2> node_slam = solution.node_slam;
  std::vector<Vector2d> node_stretch = solution.node_stretch;
  for (const NodeIndex node : nodes) {
    const Vector2d& center = mesh.centers()[node];
    const Matrix2d linear = plate.jacobian(center) / solution.global_fit.scale;
    const double heading = std::atan2(linear(1, 0) - linear(0, 1), linear(0, 0) + linear(1, 1));
    const Vector2d factors = (rotationMatrix(-heading) * linear).diagonal();
    if (!(linear.determinant() > 0.0) || !(factors.minCoeff() > kSmallestFactor)) return false;
    Pose2& pose = node_slam[node];
    pose.translation += share * (plate * center - pose.translation);
    pose.heading = wrapAngle(pose.heading + share * wrapAngle(heading - pose.heading));
    node_stretch[node] += share * (Vector2d(factors.array().log()) - node_stretch[node]);
  }
  solution.node_slam = std::move(node_slam);
  solution.node_stretch = std::move(node_stretch);
  solution.plate_share = share;
  return true;
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
