// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "cad2slam/solver/minimiser.h"
#include "cad2slam/solver/objective.h"

namespace cad2slam {

/// The same minimisation by ceres::Problem with analytic Jacobians and a Cauchy loss: the reference for minimise().
[[nodiscard]] MinimiserReport minimiseWithCeres(const Objective& objective, Eigen::VectorXd& x,
                                                const MinimiserOptions& options, const IterationCallback& on_iteration);

}  // namespace cad2slam
