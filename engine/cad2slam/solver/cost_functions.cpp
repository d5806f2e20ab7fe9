// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/solver/cost_functions.h"

#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "cad2slam/geometry/angle.h"

namespace cad2slam {
namespace {

using RowMajorBlock = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

Eigen::Map<RowMajorBlock> blockOf(double* jacobian, int rows, int columns) {
  return {jacobian, rows, columns};
}

class EdgeCost final : public ceres::CostFunction {
 public:
  EdgeCost(const Objective& objective, const EdgeTerm& edge) : objective_(objective), edge_(edge) {
    set_num_residuals(objective.unknowns);
    *mutable_parameter_block_sizes() = {objective.unknowns, objective.unknowns};
  }

  bool Evaluate(double const* const* nodes, double* residuals, double** jacobians) const override {
    const int size = objective_.unknowns;
    const EdgeLinearisation at = linearise(objective_, edge_, nodes[0], nodes[1]);
    Eigen::Map<Eigen::VectorXd>(residuals, size) = at.residual.head(size);
    if (jacobians == nullptr) return true;
    const std::array<double, 5> slopes{0.0, 0.0, objective_.sqrt_lambda_theta, objective_.sqrt_lambda_stretch,
                                       objective_.sqrt_lambda_stretch};
    for (int block = 0; block < 2; ++block) {
      if (jacobians[block] == nullptr) continue;
      auto jacobian = blockOf(jacobians[block], size, size);
      jacobian.setZero();
      jacobian.topRows<2>() = (block == 0 ? at.from : at.to).leftCols(size);
      for (int q = 2; q < size; ++q) jacobian(q, q) = (block == 0 ? -1.0 : 1.0) * slopes[static_cast<std::size_t>(q)];
    }
    return true;
  }

 private:
  const Objective& objective_;
  const EdgeTerm& edge_;
};

class NodeCost final : public ceres::CostFunction {
 public:
  NodeCost(const Objective& objective, std::size_t node)
      : objective_(objective), heading_weight_(objective.heading_prior.empty() ? 0.0 : objective.heading_prior[node]) {
    set_num_residuals(objective.unknowns == kStretchUnknowns ? 3 : 1);
    *mutable_parameter_block_sizes() = {objective.unknowns};
  }

  bool Evaluate(double const* const* nodes, double* residuals, double** jacobians) const override {
    const double* node = nodes[0];
    residuals[0] = heading_weight_ * wrapAngle(node[2] - objective_.prior_heading);
    const bool stretches = objective_.unknowns == kStretchUnknowns;
    if (stretches) {
      residuals[1] = objective_.sqrt_prior * (node[3] - node[4]);
      residuals[2] = objective_.sqrt_prior * (node[3] + node[4]);
    }
    if (jacobians == nullptr || jacobians[0] == nullptr) return true;
    auto jacobian = blockOf(jacobians[0], num_residuals(), objective_.unknowns);
    jacobian.setZero();
    jacobian(0, 2) = heading_weight_;
    if (stretches) {
      jacobian(1, 3) = jacobian(2, 3) = jacobian(2, 4) = objective_.sqrt_prior;
      jacobian(1, 4) = -objective_.sqrt_prior;
    }
    return true;
  }

 private:
  const Objective& objective_;
  double heading_weight_;
};

class AnchorCost final : public ceres::CostFunction {
 public:
  AnchorCost(const Objective& objective, const AnchorTerm& anchor)
      : sqrt_information_(std::sqrt(objective.anchor_information)), anchor_(anchor) {
    // Evaluated on the blocks it gets, so its nodes are numbered by block.
    local_.unknowns = objective.unknowns;
    for (std::size_t k = 0; k < anchor_.blend.count; ++k) anchor_.blend.nodes[k] = static_cast<NodeIndex>(k);
    set_num_residuals(2);
    mutable_parameter_block_sizes()->assign(anchor_.blend.count, objective.unknowns);
  }

  bool Evaluate(double const* const* nodes, double* residuals, double** jacobians) const override {
    const auto size = static_cast<std::size_t>(local_.unknowns);
    std::array<double, NodeBlend::kCapacity * kStretchUnknowns> gathered;
    for (std::size_t k = 0; k < anchor_.blend.count; ++k) std::copy_n(nodes[k], size, gathered.data() + k * size);
    Eigen::Map<Eigen::Vector2d>(residuals, 2) = sqrt_information_ * residualOf(local_, anchor_, gathered.data());
    if (jacobians == nullptr) return true;
    for (std::size_t k = 0; k < anchor_.blend.count; ++k) {
      if (jacobians[k] == nullptr) continue;
      blockOf(jacobians[k], 2, local_.unknowns) =
          sqrt_information_ * derivativeOf(local_, anchor_, k, gathered.data()).leftCols(local_.unknowns);
    }
    return true;
  }

 private:
  double sqrt_information_;
  AnchorTerm anchor_;
  Objective local_;
};

}  // namespace

std::unique_ptr<ceres::CostFunction> makeEdgeCost(const Objective& objective, const EdgeTerm& edge) {
  return std::make_unique<EdgeCost>(objective, edge);
}
std::unique_ptr<ceres::CostFunction> makeNodeCost(const Objective& objective, std::size_t node) {
  return std::make_unique<NodeCost>(objective, node);
}
std::unique_ptr<ceres::CostFunction> makeAnchorCost(const Objective& objective, const AnchorTerm& anchor) {
  return std::make_unique<AnchorCost>(objective, anchor);
}

}  // namespace cad2slam
