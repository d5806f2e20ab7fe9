// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/solver/stiffness_scout.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "cad2slam/solver/global_fit.h"
#include "cad2slam/solver/residual_scores.h"

namespace cad2slam {
namespace {

std::shared_ptr<const Mesh> coarse(const Mesh& mesh) {
  constexpr double kNodes = 400.0;
  const int factor = static_cast<int>(std::ceil(std::sqrt(static_cast<double>(mesh.nodeCount()) / kNodes)));
  return std::make_shared<const Mesh>(coarsened(mesh, std::max(1, factor)));
}

/// The mean leave-one-out residual [m], with what speaks against a stiffness added. Tried on many buildings
/// (`cad2slam-cli evaluate sites` and the paper's); the optimum is flat.
double scoreOf(Stiffness stiffness, const Solution& solution) {
  constexpr double kClearlyBetter = 1.1;
  std::vector<double> residuals;
  for (const AnchorFit& fit : solution.anchors) {
    if (fit.used) residuals.push_back(fit.leave_one_out_m);
  }
  const double score = cappedMean(std::move(residuals));
  if (stiffness == Stiffness::kSmooth) return kClearlyBetter * score;
  if (stiffness == Stiffness::kLoose && score > kNoise_m) return std::numeric_limits<double>::infinity();
  return score;
}

}  // namespace

StiffnessScout::StiffnessScout(const Mesh& mesh) : mesh_(coarse(mesh)) {
  while (candidates_.size() < kMeshes.size()) candidates_.push_back({MeshSolver(mesh_), std::nullopt});
}

void StiffnessScout::forget() {
  for (Candidate& candidate : candidates_) candidate.last.reset();
}

Stiffness StiffnessScout::choose(const AnchorList& anchors, const SolverSettings& settings) {
  constexpr std::size_t kFewestAnchors = 9;    // eight judge DEMO and DIAG worse than no choice
  constexpr double kGoodEnoughToJudge = 1e-4;  // of the gradient: residuals are then right to some millimetres
  Stiffness best = Stiffness::kLocal;
  if (enabledPairs(anchors).size() < kFewestAnchors) return best;
  double best_score = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < kMeshes.size(); ++k) {
    SolverSettings to_judge = withStiffness(settings, kMeshes[k]);
    to_judge.gradient_tolerance = std::max(to_judge.gradient_tolerance, kGoodEnoughToJudge);
    // Too short to be cancelled.
    auto& [solver, last] = candidates_[k];
    Result<Solution> solution = solver.solve(anchors, to_judge, last ? &*last : nullptr, {});
    last.reset();
    if (!solution) continue;
    last = std::move(*solution);
    const double score = scoreOf(kMeshes[k], *last);
    if (!(score < best_score)) continue;
    best = kMeshes[k];
    best_score = score;
  }
  return best;
}

}  // namespace cad2slam
