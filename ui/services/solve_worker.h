// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cad2slam/solver/mesh_solver.h"
#include "ui/services/solve_types.h"

#include <list>
#include <memory>
#include <vector>

namespace cad2slam {

/// Does the work of SolveService on one thread at a time. Keeps meshes and solvers of the last few requests, so that
/// the next solve after an edit starts from the last one.
class SolveWorker {
 public:
  SolveWorker();
  ~SolveWorker();

  [[nodiscard]] Result<SolveResultPtr> solve(const SolveRequest& request, const IterationCallback& on_iteration);

  /// The same from nothing, and nothing is kept of it: for a SLAM map that is only looked at.
  [[nodiscard]] Result<SolveResultPtr> solveAside(const SolveRequest& request,
                                                  const IterationCallback& on_iteration) const;

  /// Standard deviation [m] of the projection of a place of the blueprint, from the last full solve of that SLAM map;
  /// NaN where nothing is known.
  [[nodiscard]] double sigma(const std::string& map, const Eigen::Vector2d& point_in_blueprint) const;

 private:
  struct Bench;  // one mesh with its solver and the solution to start from

  [[nodiscard]] Result<Bench*> benchFor(const SolveRequest& request);
  [[nodiscard]] Result<std::shared_ptr<const Mesh>> meshFor(const SolveRequest& request) const;

  std::list<Bench> benches_;  // most recently used first
};

}  // namespace cad2slam
