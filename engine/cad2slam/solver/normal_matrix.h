// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include <memory>
#include <vector>

#include "cad2slam/solver/objective.h"

namespace cad2slam {

/// The Gauss-Newton matrix J^T W J of an objective and its sparse Cholesky factor L (CHOLMOD, supernodal).
/// The sparsity pattern and its analysis are kept as long as the couplings between nodes stay the same.
class NormalMatrix {
 public:
  NormalMatrix();
  ~NormalMatrix();
  NormalMatrix(NormalMatrix&&) noexcept;
  NormalMatrix& operator=(NormalMatrix&&) noexcept;

  /// Prepares for the couplings of `objective`: orders its nodes so that L stays sparse. Where the last factor may
  /// serve for `objective` too, another thread does that while it does. False: out of memory.
  [[nodiscard]] bool analyse(const Objective& objective);

  /// Whether that other thread found no memory; waits for it. No factorise() succeeds then.
  [[nodiscard]] bool isOutOfMemory() const;

  /// Floating-point operations of one factorisation, as analysed.
  [[nodiscard]] double operations() const;

  /// Evaluates at `x` and factorises J^T W J + damping * diag(J^T W J). False where that is not positive definite.
  [[nodiscard]] bool factorise(const Objective& objective, const double* x, double damping);

  /// So that the next solve() is after a factorise().
  void forgetFactor();
  /// There is a factor of the nodes of `objective`.
  [[nodiscard]] bool hasFactorFor(const Objective& objective) const;

  /// Makes the last factor one for `objective` at `x`, roughly, where it has the same nodes, and up to four anchors are
  /// new since then or gone: a minimiser starts with it in a third of the time of a factorisation. False: factorise.
  [[nodiscard]] bool adaptFactor(const Objective& objective, const double* x);

  /// Solves with the last factor.
  [[nodiscard]] bool solve(const Eigen::VectorXd& right, Eigen::VectorXd& solution);

  /// A thin matrix b with few non-zeros, as (row, values of its columns): one of two columns leaves the others zero.
  struct SparseColumns {
    std::vector<std::size_t> rows;
    std::vector<Eigen::Vector4d> values;
    int count = 4;  ///< of columns: 2 or 4
  };
  /// b^T (J^T W J)^-1 b of each, as the Gram matrices of L^-1 P b. Touches only the paths of the elimination tree above
  /// the non-zeros, of neighbours together, so it costs far less than as many solves.
  [[nodiscard]] std::vector<Eigen::Matrix4d> inverseForms(const std::vector<SparseColumns>& forms) const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace cad2slam
