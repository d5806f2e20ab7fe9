// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include <memory>
#include <optional>
#include <vector>

#include "cad2slam/anchors/anchor.h"
#include "cad2slam/core/result.h"
#include "cad2slam/mesh/mesh.h"
#include "cad2slam/solver/solution.h"
#include "cad2slam/solver/solve_progress.h"
#include "cad2slam/solver/solver_settings.h"

namespace cad2slam {

/// Which library minimises the objective. Both evaluate the same residuals; their minima agree.
enum class SolverBackend {
  kDirect,  ///< Gauss-Newton on CHOLMOD with a node ordering and a factor kept between solves
  kCeres,   ///< ceres::Problem with analytic Jacobians: slower, the reference
};

/// Fits one mesh to anchors. Keeps the ordering and the last factorisation of its mesh, so that solving again after an
/// edit is cheap; results never depend on what was solved before beyond the tolerance of the optimisation.
/// One solver must not be used by two threads at once; different solvers are independent.
class MeshSolver {
 public:
  explicit MeshSolver(std::shared_ptr<const Mesh> mesh, SolverBackend backend = SolverBackend::kDirect);
  ~MeshSolver();
  MeshSolver(MeshSolver&&) noexcept;
  MeshSolver& operator=(MeshSolver&&) noexcept;

  [[nodiscard]] const Mesh& mesh() const;

  /// Minimises DESIGN.md section 3 over all enabled anchors.
  /// `warm_start`: a solution of the same mesh and model to start from; empty starts at the global fit.
  /// One anchor gives a translation, two a similarity without mesh deformation; three and more the mesh.
  /// kDegenerate: no enabled anchor, or nothing but one place; kMalformed: checkAnchors() without frames says no;
  /// kNotConverged: no finite minimum was reached; kCancelled: the callback said stop.
  [[nodiscard]] Result<Solution> solve(const AnchorList& anchors, const SolverSettings& settings,
                                       const Solution* warm_start = nullptr,
                                       const IterationCallback& on_iteration = {});

  /// Standard deviation [m] of the projection at places of the blueprint [m], from the last factorisation and the
  /// leave-one-out residuals of the last solve. NaN where the last solve had no mesh (fewer than 3 anchors).
  [[nodiscard]] std::vector<double> projectionSigma(const std::vector<Eigen::Vector2d>& points_in_blueprint) const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace cad2slam
