// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/solver/plate_mixing.h"

#include <Eigen/LU>

#include <cmath>
#include <utility>
#include <vector>

#include "cad2slam/solver/node_blend.h"

namespace cad2slam {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;

constexpr double kSmallestFactor = 0.05;  // of stretch; a plate that shrinks more is about to fold

}  // namespace

bool mixIn(const ThinPlateFit& plate, double share, const Mesh& mesh, Solution& solution) {
  std::vector<Pose2> node_slam = solution.node_slam;
  std::vector<Vector2d> node_stretch = solution.node_stretch;
  for (NodeIndex node = 0; node < mesh.nodeCount(); ++node) {
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
