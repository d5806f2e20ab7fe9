// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/solver/stiffness_scout.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "cad2slam/solver/capped_mean.h"
#include "cad2slam/solver/global_fit.h"
#include "cad2slam/solver/thin_plate_fit.h"

namespace cad2slam {
namespace {

std::shared_ptr<const Mesh> coarse(const Mesh& mesh) {
  constexpr double kNodes = 500.0;
  const int factor = static_cast<int>(std::ceil(std::sqrt(static_cast<double>(mesh.nodeCount()) / kNodes)));
  return std::make_shared<const Mesh>(coarsened(mesh, std::max(1, factor)));
}

using Residuals = std::vector<Eigen::Vector2d>;

Residuals leaveOneOutOf(const AnchorList& anchors, const Solution& solution) {
  Residuals residuals;
  for (std::size_t i = 0; i < anchors.size(); ++i) {
    if (anchors[i].enabled) residuals.push_back(solution.anchors[i].predicted_without - anchors[i].in_slam);
  }
  return residuals;
}

double scoreOf(const Residuals& residuals) {
  std::vector<double> lengths;
  for (const Eigen::Vector2d& residual : residuals) lengths.push_back(residual.norm());
  return cappedMean(std::move(lengths));
}

double scoreOfMixture(const Residuals& mesh, const Residuals& plate, double share) {
  Residuals mixed = mesh;
  for (std::size_t i = 0; i < mixed.size(); ++i) mixed[i] += share * (plate[i] - mixed[i]);
  return scoreOf(mixed);
}

/// The share with the smallest leave-one-out residuals. Few anchors say little about it, so the weight that the mean of
/// two independent measurements would have is preferred where it is larger and costs next to nothing; it fades out
/// where the plate is much worse. In steps, so that what is left of the scout's tolerance does not show in the answer.
double plateShare(const Residuals& mesh, const Residuals& plate) {
  constexpr int kSteps = 20;
  constexpr double kNextToNothing = 1.05;
  constexpr double kAsGood = 1.2;
  constexpr double kTooBad = 1.3;
  std::array<double, kSteps + 1> scores{};
  for (int k = 0; k <= kSteps; ++k) scores[k] = scoreOfMixture(mesh, plate, static_cast<double>(k) / kSteps);
  const auto smallest = static_cast<int>(std::min_element(scores.begin(), scores.end()) - scores.begin());
  if (!(scores.front() > 0.0)) return 0.0;
  const double ratio = scores.back() / scores.front();
  const double faded = std::clamp((kTooBad - ratio) / (kTooBad - kAsGood), 0.0, 1.0) / (1.0 + ratio * ratio);
  int preferred = static_cast<int>(std::lround(kSteps * faded));
  while (preferred > 0 && scores[preferred] > kNextToNothing * scores.front()) --preferred;
  return static_cast<double>(std::max(smallest, preferred)) / kSteps;
}

/// Empty where there is no plate, or one that folds.
Residuals plateResiduals(const Mesh& mesh, const std::vector<PointPair>& pairs, const SolverSettings& settings) {
  const Result<ThinPlateFit> plate = ThinPlateFit::create(pairs, settings.loss_width_m);
  if (!plate) return {};
  const bool folds = std::any_of(mesh.centers().begin(), mesh.centers().end(), [&](const Eigen::Vector2d& center) {
    return !(plate->jacobian(center).determinant() > 0.0);
  });
  return folds ? Residuals{} : plate->leaveOneOut();
}

}  // namespace

StiffnessScout::StiffnessScout(const Mesh& mesh) : mesh_(coarse(mesh)) {
  while (candidates_.size() < kMeshes.size()) candidates_.push_back({MeshSolver(mesh_), std::nullopt});
}

StiffnessChoice StiffnessScout::choose(const AnchorList& anchors, const SolverSettings& settings) {
  constexpr std::size_t kFewestAnchors = 5;
  constexpr double kGoodEnoughToJudge = 1e-4;  // of the gradient: residuals are then right to some millimetres
  const std::vector<PointPair> pairs = enabledPairs(anchors);
  StiffnessChoice choice;
  if (pairs.size() < kFewestAnchors) return choice;
  double best_score = std::numeric_limits<double>::infinity();
  Residuals best;
  for (std::size_t k = 0; k < kMeshes.size(); ++k) {
    SolverSettings to_judge = withStiffness(settings, kMeshes[k]);
    to_judge.gradient_tolerance = std::max(to_judge.gradient_tolerance, kGoodEnoughToJudge);
    // Too short to be cancelled.
    auto& [solver, last] = candidates_[k];
    Result<Solution> solution = solver.solve(anchors, to_judge, last ? &*last : nullptr, {});
    last.reset();
    if (!solution) continue;
    Residuals residuals = leaveOneOutOf(anchors, *solution);
    last = std::move(*solution);
    const double score = scoreOf(residuals);
    if (score >= best_score) continue;
    choice.stiffness = kMeshes[k];
    best_score = score;
    best = std::move(residuals);
  }
  const Residuals plate = plateResiduals(*mesh_, pairs, settings);
  if (!best.empty() && !plate.empty()) choice.plate_share = plateShare(best, plate);
  return choice;
}

}  // namespace cad2slam
