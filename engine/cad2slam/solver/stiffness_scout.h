// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "cad2slam/anchors/anchor.h"
#include "cad2slam/mesh/mesh.h"
#include "cad2slam/solver/mesh_solver.h"
#include "cad2slam/solver/solver_settings.h"

namespace cad2slam {

/// Finds the stiffness that suits a map: fits a coarse mesh with each and takes the one whose leave-one-out residuals
/// are smallest, kSmooth only where it is clearly better and kLoose only where these could be noise of clicks. Keeps
/// its fits, so that choosing again after an edit is cheap.
class StiffnessScout {
 public:
  explicit StiffnessScout(const Mesh& mesh);

  /// Forgets its fits: the next choice depends on its arguments alone.
  void forget();

  /// One of kLocal (always below nine anchors), kSmooth, kLoose.
  [[nodiscard]] Stiffness choose(const AnchorList& anchors, const SolverSettings& settings);

 private:
  static constexpr std::array kMeshes = {Stiffness::kLocal, Stiffness::kSmooth, Stiffness::kLoose};

  /// Of one stiffness: its factor would only mislead the others.
  struct Candidate {
    MeshSolver solver;
    std::optional<Solution> last;
  };

  std::shared_ptr<const Mesh> mesh_;
  std::vector<Candidate> candidates_;  ///< one for each of kMeshes
};

}  // namespace cad2slam
