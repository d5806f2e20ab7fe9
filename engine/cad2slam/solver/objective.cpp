// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/solver/objective.h"

#include <cmath>

#include "cad2slam/geometry/angle.h"

namespace cad2slam {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;
using Matrix25d = Eigen::Matrix<double, 2, 5>;
using Vector5d = Eigen::Matrix<double, 5, 1>;

bool stretches(const Objective& objective) {
  return objective.unknowns == kStretchUnknowns;
}

/// Rest offset of an edge under the mean stretch of its ends.
Vector2d stretchedRest(const Objective& objective, const EdgeTerm& edge, const double* from, const double* to) {
  if (!stretches(objective)) return edge.rest;
  return {std::exp(0.5 * (from[3] + to[3])) * edge.rest.x(), std::exp(0.5 * (from[4] + to[4])) * edge.rest.y()};
}

/// R(theta) diag(exp(a)) offset.
Vector2d turnedAndStretched(const Objective& objective, const double* node, const Vector2d& offset) {
  Vector2d stretched = offset;
  if (stretches(objective)) stretched = {std::exp(node[3]) * offset.x(), std::exp(node[4]) * offset.y()};
  return rotationMatrix(node[2]) * stretched;
}

Vector5d edgeResidual(const Objective& objective, const EdgeTerm& edge, const double* from, const double* to,
                      const Vector2d& local, const Vector2d& rest) {
  Vector5d residual = Vector5d::Zero();
  residual.head<2>() = edge.whitener * (local - rest);
  residual[2] = objective.sqrt_lambda_theta * wrapAngle(to[2] - from[2]);
  if (stretches(objective)) {
    residual[3] = objective.sqrt_lambda_stretch * (to[3] - from[3]);
    residual[4] = objective.sqrt_lambda_stretch * (to[4] - from[4]);
  }
  return residual;
}

Vector2d localOffset(const double* from, const double* to) {
  const double c = std::cos(from[2]);
  const double s = std::sin(from[2]);
  const double dx = to[0] - from[0];
  const double dy = to[1] - from[1];
  return {c * dx + s * dy, c * dy - s * dx};
}

/// Stretch prior and heading prior of one node.
Vector2d priorResidual(const Objective& objective, const double* node) {
  if (!stretches(objective)) return Vector2d::Zero();
  return objective.sqrt_prior * Vector2d(node[3] - node[4], node[3] + node[4]);
}

double headingResidual(const Objective& objective, std::size_t node, const double* unknowns) {
  if (objective.heading_prior.empty() || objective.heading_prior[node] == 0.0) return 0.0;
  return objective.heading_prior[node] * wrapAngle(unknowns[2] - objective.prior_heading);
}

}  // namespace

double anchorCost(double squared_residual_m2, double information, double loss_width_m) {
  if (!(loss_width_m > 0.0)) return 0.5 * information * squared_residual_m2;
  const double width_squared = loss_width_m * loss_width_m;
  return 0.5 * information * width_squared * std::log1p(squared_residual_m2 / width_squared);
}

EdgeLinearisation linearise(const Objective& objective, const EdgeTerm& edge, const double* from, const double* to) {
  const Vector2d local = localOffset(from, to);
  const Vector2d rest = stretchedRest(objective, edge, from, to);
  EdgeLinearisation result;
  result.residual = edgeResidual(objective, edge, from, to, local, rest);
  const Matrix2d by_offset = edge.whitener * rotationMatrix(-from[2]);
  result.from.leftCols<2>() = -by_offset;
  result.to.leftCols<2>() = by_offset;
  result.from.col(2) = edge.whitener * Vector2d(local.y(), -local.x());
  result.to.col(2).setZero();
  if (stretches(objective)) {
    const Matrix2d by_stretch = edge.whitener * Vector2d(-0.5 * rest).asDiagonal();
    result.from.rightCols<2>() = by_stretch;
    result.to.rightCols<2>() = by_stretch;
  } else {
    result.from.rightCols<2>().setZero();
    result.to.rightCols<2>().setZero();
  }
  return result;
}

Vector5d residualOf(const Objective& objective, const EdgeTerm& edge, const double* from, const double* to) {
  return edgeResidual(objective, edge, from, to, localOffset(from, to), stretchedRest(objective, edge, from, to));
}

Vector2d residualOf(const Objective& objective, const AnchorTerm& anchor, const double* unknowns) {
  Vector2d predicted = Vector2d::Zero();
  for (std::size_t k = 0; k < anchor.blend.count; ++k) {
    const double* node = unknowns + anchor.blend.nodes[k] * static_cast<std::size_t>(objective.unknowns);
    predicted +=
        anchor.blend.weights[k] * (Vector2d(node[0], node[1]) + turnedAndStretched(objective, node, anchor.offsets[k]));
  }
  return predicted - anchor.target;
}

Matrix25d derivativeOf(const Objective& objective, const AnchorTerm& anchor, std::size_t k, const double* unknowns) {
  const double* node = unknowns + anchor.blend.nodes[k] * static_cast<std::size_t>(objective.unknowns);
  const Vector2d arm = turnedAndStretched(objective, node, anchor.offsets[k]);
  Matrix25d derivative = Matrix25d::Zero();
  derivative(0, 0) = derivative(1, 1) = 1.0;
  derivative.col(2) = Vector2d(-arm.y(), arm.x());
  if (stretches(objective)) {
    const Vector2d& offset = anchor.offsets[k];
    derivative.col(3) = rotationMatrix(node[2]) * Vector2d(std::exp(node[3]) * offset.x(), 0.0);
    derivative.col(4) = rotationMatrix(node[2]) * Vector2d(0.0, std::exp(node[4]) * offset.y());
  }
  return anchor.blend.weights[k] * derivative;
}

double costAt(const Objective& objective, const double* x) {
  const auto unknowns = static_cast<std::size_t>(objective.unknowns);
  double cost = 0.0;
  for (const EdgeTerm& edge : objective.edges) {
    cost += 0.5 * residualOf(objective, edge, x + edge.from * unknowns, x + edge.to * unknowns).squaredNorm();
  }
  for (std::size_t node = 0; node < objective.nodeCount(); ++node) {
    cost += 0.5 * priorResidual(objective, x + node * unknowns).squaredNorm();
    cost += 0.5 * std::pow(headingResidual(objective, node, x + node * unknowns), 2);
  }
  for (const AnchorTerm& anchor : objective.anchors) {
    cost += anchorCost(residualOf(objective, anchor, x).squaredNorm(), objective.anchor_information,
                       objective.loss_width_m);
  }
  return cost;
}

double gradientAt(const Objective& objective, const double* x, double* gradient) {
  const auto unknowns = static_cast<std::size_t>(objective.unknowns);
  Eigen::Map<Eigen::VectorXd>(gradient, static_cast<Eigen::Index>(objective.size())).setZero();
  const auto add = [&](std::size_t node, const Vector5d& part) {
    for (std::size_t q = 0; q < unknowns; ++q) gradient[node * unknowns + q] += part[static_cast<Eigen::Index>(q)];
  };
  double cost = 0.0;
  for (const EdgeTerm& edge : objective.edges) {
    const EdgeLinearisation edge_at = linearise(objective, edge, x + edge.from * unknowns, x + edge.to * unknowns);
    cost += 0.5 * edge_at.residual.squaredNorm();
    Vector5d from = edge_at.from.transpose() * edge_at.residual.head<2>();
    Vector5d to = edge_at.to.transpose() * edge_at.residual.head<2>();
    const Vector5d whitened(0.0, 0.0, objective.sqrt_lambda_theta * edge_at.residual[2],
                            objective.sqrt_lambda_stretch * edge_at.residual[3],
                            objective.sqrt_lambda_stretch * edge_at.residual[4]);
    add(edge.from, from - whitened);
    add(edge.to, to + whitened);
  }
  for (std::size_t node = 0; node < objective.nodeCount(); ++node) {
    const double* at = x + node * unknowns;
    const Vector2d prior = priorResidual(objective, at);
    const double heading = headingResidual(objective, node, at);
    cost += 0.5 * (prior.squaredNorm() + heading * heading);
    if (heading != 0.0) gradient[node * unknowns + 2] += objective.heading_prior[node] * heading;
    if (!stretches(objective)) continue;
    gradient[node * unknowns + 3] += objective.sqrt_prior * (prior.y() + prior.x());
    gradient[node * unknowns + 4] += objective.sqrt_prior * (prior.y() - prior.x());
  }
  for (const AnchorTerm& anchor : objective.anchors) {
    const Vector2d residual = residualOf(objective, anchor, x);
    cost += anchorCost(residual.squaredNorm(), objective.anchor_information, objective.loss_width_m);
    const double weight = objective.anchor_information * lossWeight(residual.squaredNorm(), objective.loss_width_m);
    for (std::size_t k = 0; k < anchor.blend.count; ++k) {
      add(anchor.blend.nodes[k], derivativeOf(objective, anchor, k, x).transpose() * (weight * residual));
    }
  }
  return cost;
}

}  // namespace cad2slam
