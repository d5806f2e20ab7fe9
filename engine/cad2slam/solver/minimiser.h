// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "cad2slam/solver/normal_matrix.h"
#include "cad2slam/solver/objective.h"
#include "cad2slam/solver/solve_progress.h"

namespace cad2slam {

struct MinimiserOptions {
  int max_iterations = 100;
  double gradient_tolerance = 1e-9;
  double gradient_at_start = 1.0;  ///< max norm that relative gradients refer to
};

struct MinimiserReport {
  double cost = 0.0;
  double relative_gradient = 0.0;
  int iterations = 0;
  bool converged = false;
  bool cancelled = false;
  bool finite = true;  ///< false: the objective or its factorisation broke down
};

/// Minimises `objective` from `x`, which holds the minimum afterwards.
/// A factorisation costs as much as twenty gradients, so Gauss-Newton factorises only now and then: each factor serves
/// as the initial inverse Hessian of L-BFGS (Nocedal and Wright, alg. 7.4) for as long as that makes good progress.
/// `normal` must have been analysed for the objective; a factor it still holds from an earlier solve is used first.
[[nodiscard]] MinimiserReport minimise(const Objective& objective, Eigen::VectorXd& x, NormalMatrix& normal,
                                       const MinimiserOptions& options, const IterationCallback& on_iteration);

}  // namespace cad2slam
