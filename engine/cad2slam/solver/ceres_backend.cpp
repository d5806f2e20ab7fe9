// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/solver/ceres_backend.h"

#include <ceres/iteration_callback.h>
#include <ceres/loss_function.h>
#include <ceres/problem.h>
#include <ceres/solver.h>

#include <cmath>
#include <vector>

#include "cad2slam/solver/cost_functions.h"

namespace cad2slam {
namespace {

/// Reports each iteration with the gradient as a part of the gradient at the global fit, and stops where minimise()
/// would stop.
class Progress final : public ceres::IterationCallback {
 public:
  Progress(const MinimiserOptions& options, const cad2slam::IterationCallback& on_iteration)
      : options_(options), on_iteration_(on_iteration) {}

  ceres::CallbackReturnType operator()(const ceres::IterationSummary& summary) override {
    const double relative = summary.gradient_max_norm / options_.gradient_at_start;
    if (summary.iteration > 0 && on_iteration_ &&
        on_iteration_({summary.iteration, summary.cost, relative}) == NextStep::kStop) {
      return ceres::SOLVER_ABORT;
    }
    return relative <= options_.gradient_tolerance ? ceres::SOLVER_TERMINATE_SUCCESSFULLY : ceres::SOLVER_CONTINUE;
  }

 private:
  const MinimiserOptions& options_;
  const cad2slam::IterationCallback& on_iteration_;
};

}  // namespace

MinimiserReport minimiseWithCeres(const Objective& objective, Eigen::VectorXd& x, const MinimiserOptions& options,
                                  const IterationCallback& on_iteration) {
  const auto size = static_cast<std::size_t>(objective.unknowns);
  const auto block = [&](std::size_t node) { return x.data() + node * size; };
  ceres::Problem problem;
  for (std::size_t node = 0; node < objective.nodeCount(); ++node)
    problem.AddParameterBlock(block(node), objective.unknowns);
  for (const EdgeTerm& edge : objective.edges) {
    problem.AddResidualBlock(makeEdgeCost(objective, edge).release(), nullptr, block(edge.from), block(edge.to));
  }
  for (std::size_t node = 0; node < objective.nodeCount(); ++node) {
    problem.AddResidualBlock(makeNodeCost(objective, node).release(), nullptr, block(node));
  }
  for (const AnchorTerm& anchor : objective.anchors) {
    std::vector<double*> blocks;
    for (std::size_t k = 0; k < anchor.blend.count; ++k) blocks.push_back(block(anchor.blend.nodes[k]));
    const double width = objective.loss_width_m * std::sqrt(objective.anchor_information);
    problem.AddResidualBlock(makeAnchorCost(objective, anchor).release(),
                             width > 0.0 ? new ceres::CauchyLoss(width) : nullptr, blocks);
  }

  ceres::Solver::Options solver;
  solver.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
  solver.sparse_linear_algebra_library_type = ceres::SUITE_SPARSE;
  solver.max_num_iterations = options.max_iterations;
  solver.function_tolerance = 0.0;
  solver.gradient_tolerance = 0.0;
  solver.parameter_tolerance = 1e-14;
  solver.logging_type = ceres::SILENT;
  Progress progress(options, on_iteration);
  solver.callbacks.push_back(&progress);
  solver.update_state_every_iteration = false;
  ceres::Solver::Summary summary;
  ceres::Solve(solver, &problem, &summary);

  MinimiserReport report;
  Eigen::VectorXd gradient(x.size());
  report.cost = gradientAt(objective, x.data(), gradient.data());
  report.relative_gradient = gradient.lpNorm<Eigen::Infinity>() / options.gradient_at_start;
  report.iterations = static_cast<int>(summary.iterations.size()) - 1;
  report.cancelled = summary.termination_type == ceres::USER_FAILURE;
  report.finite = summary.termination_type != ceres::FAILURE && std::isfinite(report.cost);
  // Ceres also ends where steps drown in rounding; minimise() would count the same place as its minimum.
  report.converged = report.relative_gradient <= std::max(1e-8, options.gradient_tolerance);
  return report;
}

}  // namespace cad2slam
