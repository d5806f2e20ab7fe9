// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/solver/mesh_solver.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <future>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "cad2slam/anchors/anchor_checks.h"
#include "cad2slam/solver/build_objective.h"
#include "cad2slam/solver/ceres_backend.h"
#include "cad2slam/solver/global_fit.h"
#include "cad2slam/solver/minimiser.h"
#include "cad2slam/solver/mixing.h"
#include "cad2slam/solver/normal_matrix.h"
#include "cad2slam/solver/objective.h"
#include "cad2slam/solver/one_thread.h"
#include "cad2slam/solver/second_thread.h"
#include "cad2slam/solver/stiffness_scout.h"
#include "cad2slam/solver/thin_plate_fit.h"

namespace cad2slam {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;

constexpr char kOnePlaceWarning[] =
    "One place is anchored: only the translation is known; add an anchor far away from it.";
constexpr char kTwoPlacesWarning[] =
    "Two places are anchored: only rotation and translation are known; a third anchor lets the mesh bend.";
/// Share of a place that other anchors determine; below it the first-order formula only magnifies rounding.
constexpr double kNothingElse = 1e-5;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

class Stopwatch {
 public:
  [[nodiscard]] double lap() {
    const auto now = std::chrono::steady_clock::now();
    const double seconds = std::chrono::duration<double>(now - start_).count();
    start_ = now;
    return seconds;
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

Solution rigidSolution(const Mesh& mesh, const Similarity2& global_fit) {
  Solution solution;
  solution.global_fit = global_fit;
  solution.node_slam.reserve(mesh.nodeCount());
  for (const Vector2d& center : mesh.centers()) solution.node_slam.push_back(global_fit * Pose2{center, 0.0});
  solution.node_stretch.assign(mesh.nodeCount(), Vector2d::Zero());
  return solution;
}

/// Writes the derivative of up to two anchor terms into one thin matrix: columns 0, 1 of `left`, columns 2, 3 of
/// `right`.
NormalMatrix::SparseColumns derivativeColumns(const Objective& objective, const AnchorTerm& left,
                                              const AnchorTerm* right, const double* x) {
  NormalMatrix::SparseColumns columns;
  const auto append = [&](const AnchorTerm& term, Eigen::Index first_column) {
    for (std::size_t k = 0; k < term.blend.count; ++k) {
      const Eigen::Matrix<double, 2, 5> derivative = derivativeOf(objective, term, k, x);
      for (int q = 0; q < objective.unknowns; ++q) {
        Eigen::Vector4d value = Eigen::Vector4d::Zero();
        value.segment<2>(first_column) = derivative.col(q);
        columns.rows.push_back(term.blend.nodes[k] * static_cast<std::size_t>(objective.unknowns) +
                               static_cast<std::size_t>(q));
        columns.values.push_back(value);
      }
    }
  };
  append(left, 0);
  if (right != nullptr) append(*right, 2);
  columns.count = right != nullptr ? 4 : 2;
  return columns;
}

std::string plural(std::size_t count, const std::string& one, const std::string& many) {
  std::string text = std::to_string(count);
  text += ' ';
  text += count == 1 ? one : many;
  return text;
}

}  // namespace

class MeshSolver::Impl {
 public:
  Impl(std::shared_ptr<const Mesh> mesh, SolverBackend backend) : mesh_(std::move(mesh)), backend_(backend) {}

  [[nodiscard]] const Mesh& mesh() const { return *mesh_; }
  Result<Solution> solve(const AnchorList& anchors, const SolverSettings& settings, const Solution* warm_start,
                         const IterationCallback& on_iteration);
  [[nodiscard]] std::vector<double> projectionSigma(const std::vector<Vector2d>& points) const;

 private:
  Result<Solution> solveMesh(const AnchorList& anchors, const SolverSettings& settings, const Similarity2& global_fit,
                             const Solution* warm_start, const IterationCallback& on_iteration);
  Result<Solution> solveWithChosenStiffness(const AnchorList& anchors, const SolverSettings& settings,
                                            const Similarity2& global_fit, const Solution* warm_start,
                                            const IterationCallback& on_iteration);
  void mixInPlate(const AnchorList& anchors, ThinPlateFit plate, PlateAtNodes at_nodes, Solution& solution);
  void mixInGlobalFit(const AnchorList& anchors, Solution& solution) const;
  void updateFits(const AnchorList& anchors, double share, const std::vector<Vector2d>& leave_one_out,
                  Solution& solution) const;
  [[nodiscard]] MinimiserReport minimiseFrom(Eigen::VectorXd& x, const MinimiserOptions& options,
                                             const IterationCallback& on_iteration);
  void store(const Eigen::VectorXd& x, Solution& solution) const;
  void diagnoseAnchors(const AnchorList& anchors, Solution& solution);
  [[nodiscard]] AnchorTerm predictionAt(const Vector2d& in_blueprint, const Vector2d& in_slam) const;
  [[nodiscard]] Vector2d predictedByFewOthers(const AnchorList& anchors, std::size_t left_out) const;
  [[nodiscard]] bool isActive(const Vector2d& in_blueprint) const;
  void addComponentWarning(Solution& solution) const;
  [[nodiscard]] tl::unexpected<Error> tooLarge() const;

  std::shared_ptr<const Mesh> mesh_;
  SolverBackend backend_;
  NormalMatrix normal_;
  std::unique_ptr<StiffnessScout> scout_;
  std::optional<Stiffness> last_choice_;

  // Of the last mesh solve, for projectionSigma().
  Objective objective_;
  Similarity2 global_fit_;
  std::vector<std::uint32_t> active_number_;
  Eigen::VectorXd x_;
  double variance_factor_ = kNaN;
  std::optional<ThinPlateFit> plate_;
  double plate_share_ = 0.0;
};

Result<Solution> MeshSolver::Impl::solve(const AnchorList& anchors, const SolverSettings& settings,
                                         const Solution* warm_start, const IterationCallback& on_iteration) {
  const OneThread one_thread;
  variance_factor_ = kNaN;
  plate_.reset();
  if (Result<void> checked = checkAnchors(anchors, {}); !checked) return failAs(checked);
  const Result<Similarity2> global_fit = fitGlobally(anchors, settings.scale);
  if (!global_fit) return failAs(global_fit);
  const int places = distinctPlaces(anchors);
  if (places >= 3) {
    if (settings.model != Model::kStretch || settings.stiffness != Stiffness::kAutomatic) {
      return solveMesh(anchors, withStiffness(settings, settings.stiffness), *global_fit, warm_start, on_iteration);
    }
    return solveWithChosenStiffness(anchors, settings, *global_fit, warm_start, on_iteration);
  }

  Solution solution = rigidSolution(*mesh_, *global_fit);
  solution.settings = withAutomaticWeights(settings, *mesh_, global_fit->scale);
  solution.converged = true;
  for (const Anchor& anchor : anchors) {
    AnchorFit fit;
    fit.id = anchor.id;
    fit.used = anchor.enabled;
    fit.predicted = fit.predicted_without = *global_fit * anchor.in_blueprint;
    fit.residual_m = (fit.predicted - anchor.in_slam).norm();
    fit.leave_one_out_m = anchor.enabled ? kNaN : fit.residual_m;
    solution.anchors.push_back(fit);
    solution.anchors_used += anchor.enabled ? 1 : 0;
  }
  solution.warnings.emplace_back(places == 1 ? kOnePlaceWarning : kTwoPlacesWarning);
  return solution;
}

MinimiserReport MeshSolver::Impl::minimiseFrom(Eigen::VectorXd& x, const MinimiserOptions& options,
                                               const IterationCallback& on_iteration) {
  return backend_ == SolverBackend::kCeres ? minimiseWithCeres(objective_, x, options, on_iteration)
                                           : minimise(objective_, x, normal_, options, on_iteration);
}

Result<Solution> MeshSolver::Impl::solveMesh(const AnchorList& anchors, const SolverSettings& settings,
                                             const Similarity2& global_fit, const Solution* warm_start,
                                             const IterationCallback& on_iteration) {
  Stopwatch stopwatch;
  Solution solution = rigidSolution(*mesh_, global_fit);
  solution.settings = withAutomaticWeights(settings, *mesh_, global_fit.scale);
  global_fit_ = global_fit;
  objective_ = buildObjective(*mesh_, anchors, solution.settings, global_fit);
  active_number_ = activeNumbers(objective_, mesh_->nodeCount());
  if (!normal_.analyse(objective_)) return tooLarge();
  // A solve from nothing depends on nothing that was solved before: rigid meshes have more than one minimum.
  if (warm_start == nullptr) normal_.forgetFactor();
  solution.seconds.ordering = stopwatch.lap();

  MinimiserOptions options;
  options.max_iterations = settings.max_iterations;
  options.gradient_tolerance = settings.gradient_tolerance;
  const Eigen::VectorXd at_fit = startingPoint(objective_, *mesh_, global_fit, nullptr);
  Eigen::VectorXd gradient(at_fit.size());
  solution.initial_cost = gradientAt(objective_, at_fit.data(), gradient.data());
  // Where the similarity is perfect there is no gradient to compare with: then any rounding-sized one is converged.
  const double smallest_scale = 1e-2 * settings.anchor_information;
  options.gradient_at_start = std::max(smallest_scale, gradient.lpNorm<Eigen::Infinity>());

  x_ = startingPoint(objective_, *mesh_, global_fit, warm_start);
  const MinimiserReport report = minimiseFrom(x_, options, on_iteration);
  if (report.cancelled) return fail(ErrorCode::kCancelled, "the optimisation was cancelled");
  if (!report.finite || !x_.allFinite()) {
    if (normal_.isOutOfMemory()) return tooLarge();
    return fail(ErrorCode::kNotConverged,
                "the optimisation found no finite minimum; check the anchors and the weights");
  }
  solution.cost = report.cost;
  solution.iterations = report.iterations;
  solution.relative_gradient = report.relative_gradient;
  solution.converged = report.converged || report.relative_gradient <= 1e-8;
  if (!solution.converged) {
    solution.warnings.push_back("The optimisation stopped after " + std::to_string(report.iterations) +
                                " iterations before it had converged.");
  }
  store(x_, solution);
  solution.seconds.optimisation = stopwatch.lap();

  // Leave-one-out and sigma want the factor at the minimum itself.
  if (!normal_.factorise(objective_, x_.data(), 0.0)) {
    if (normal_.isOutOfMemory()) return tooLarge();
    return fail(ErrorCode::kNotConverged, "the anchors do not determine the mesh; add anchors or enable some");
  }
  diagnoseAnchors(anchors, solution);
  addComponentWarning(solution);
  solution.seconds.diagnosis = stopwatch.lap();
  return solution;
}

/// After an edit the stiffness is mostly the one of before: then the mesh is solved with that while another thread
/// makes sure and fits the plate, and solved again should it be another one. The answer is the same either way.
Result<Solution> MeshSolver::Impl::solveWithChosenStiffness(const AnchorList& anchors, const SolverSettings& settings,
                                                            const Similarity2& global_fit, const Solution* warm_start,
                                                            const IterationCallback& on_iteration) {
  if (!scout_) scout_ = std::make_unique<StiffnessScout>(*mesh_);
  if (warm_start == nullptr) scout_->forget();
  const auto solveWith = [&](Stiffness stiffness) {
    return solveMesh(anchors, withStiffness(settings, stiffness), global_fit, warm_start, on_iteration);
  };
  struct Aside {  // what does not need the solved mesh
    Stiffness stiffness;
    Result<ThinPlateFit> plate;
    PlateAtNodes plate_at_nodes;  // empty where it was not in the last answer either
  };
  const auto workAside = [&] {
    const OneThread one_thread;
    const Stiffness stiffness = scout_->choose(anchors, settings);
    Aside aside{stiffness, ThinPlateFit::create(enabledPairs(anchors), settings.loss_width_m), {}};
    if (aside.plate && warm_start != nullptr && warm_start->plate_share > 0.0) {
      aside.plate_at_nodes = atNodes(*aside.plate, *mesh_);
    }
    return aside;
  };
  std::future<Aside> working;
  if (warm_start != nullptr && last_choice_) working = onSecondThread(workAside);
  std::optional<Result<Solution>> expected;
  if (working.valid()) expected = solveWith(*last_choice_);
  Aside aside = working.valid() ? working.get() : workAside();
  const bool is_expected = expected && aside.stiffness == *last_choice_;
  last_choice_ = aside.stiffness;
  Result<Solution> solution = is_expected ? std::move(*expected) : solveWith(*last_choice_);
  if (!solution) return solution;

  Stopwatch stopwatch;
  if (aside.plate) mixInPlate(anchors, std::move(*aside.plate), std::move(aside.plate_at_nodes), *solution);
  mixInGlobalFit(anchors, *solution);
  solution->seconds.diagnosis += stopwatch.lap();
  return solution;
}

/// Moves every node that an anchor holds part of the way to a thin plate, unless that brings nothing or it folds. What
/// is left of the plate's shear between nodes cancels in the projector's blend, which is exact for affine maps.
void MeshSolver::Impl::mixInPlate(const AnchorList& anchors, ThinPlateFit plate, PlateAtNodes at_nodes,
                                  Solution& solution) {
  const double share = plateShare(anchors, solution, plate);
  if (share == 0.0) return;
  if (at_nodes.empty()) at_nodes = atNodes(plate, *mesh_);
  if (!mixIn(at_nodes, share, objective_.active_nodes, solution)) return;
  updateFits(anchors, share, plate.leaveOneOut(), solution);
  std::size_t used = 0;
  for (AnchorFit& fit : solution.anchors) {
    if (fit.used) fit.loss_weight = (1.0 - share) * fit.loss_weight + share * plate.weights()[used++];
  }
  plate_ = std::move(plate);
  plate_share_ = share;
}

/// sigma stays that of the mesh: the global fit only takes part where it is about as good.
void MeshSolver::Impl::mixInGlobalFit(const AnchorList& anchors, Solution& solution) const {
  if (solution.anchors_used > ThinPlateFit::kMostPairs) return;
  std::vector<Vector2d> residuals;
  for (const PointPair& pair : enabledPairs(anchors)) residuals.push_back(global_fit_ * pair.source - pair.target);
  if (similarityShare(solution, residuals) == 0.0) return;  // left out, they only grow, and that takes time to find
  const std::vector<Vector2d> leave_one_out = similarityLeaveOneOut(anchors, solution.settings.scale);
  const double share = similarityShare(solution, leave_one_out);
  if (share == 0.0) return;
  mixInSimilarity(share, *mesh_, objective_.active_nodes, solution);
  updateFits(anchors, share, leave_one_out, solution);
}

/// After `share` of a shape with these leave-one-out residuals of the enabled anchors was mixed in.
void MeshSolver::Impl::updateFits(const AnchorList& anchors, double share, const std::vector<Vector2d>& leave_one_out,
                                  Solution& solution) const {
  std::size_t used = 0;
  for (std::size_t i = 0; i < anchors.size(); ++i) {
    AnchorFit& fit = solution.anchors[i];
    fit.predicted = blended(*mesh_, solution, anchors[i].in_blueprint);
    fit.residual_m = (fit.predicted - anchors[i].in_slam).norm();
    if (anchors[i].enabled) {
      const Vector2d shape_without = anchors[i].in_slam + leave_one_out[used++];
      fit.predicted_without += share * (shape_without - fit.predicted_without);
      fit.leave_one_out_m = (fit.predicted_without - anchors[i].in_slam).norm();
    } else {
      fit.predicted_without = fit.predicted;
      fit.leave_one_out_m = fit.residual_m;
    }
  }
}

void MeshSolver::Impl::store(const Eigen::VectorXd& x, Solution& solution) const {
  for (std::size_t k = 0; k < objective_.nodeCount(); ++k) {
    const double* unknowns = x.data() + k * static_cast<std::size_t>(objective_.unknowns);
    const NodeIndex node = objective_.active_nodes[k];
    solution.node_slam[node] = {{unknowns[0], unknowns[1]}, wrapAngle(unknowns[2])};
    if (objective_.unknowns == kStretchUnknowns) solution.node_stretch[node] = {unknowns[3], unknowns[4]};
  }
}

bool MeshSolver::Impl::isActive(const Vector2d& in_blueprint) const {
  const NodeBlend blend = smoothBlend(*mesh_, in_blueprint);
  for (std::size_t k = 0; k < blend.count; ++k) {
    if (active_number_[blend.nodes[k]] == kInactive) return false;
  }
  return true;
}

/// What the projector will say at a place: always with its smooth weights, whatever ties the anchors of the model.
AnchorTerm MeshSolver::Impl::predictionAt(const Vector2d& in_blueprint, const Vector2d& in_slam) const {
  AnchorTerm term = makeAnchorTerm(*mesh_, smoothBlend(*mesh_, in_blueprint), in_blueprint, in_slam, global_fit_.scale);
  for (std::size_t k = 0; k < term.blend.count; ++k) term.blend.nodes[k] = active_number_[term.blend.nodes[k]];
  return term;
}

/// Where a solve without this anchor puts its place if the others leave its part of the mesh open: there the part keeps
/// the heading of their global fit (see `heading_prior`), held by the others in it if there are any.
Vector2d MeshSolver::Impl::predictedByFewOthers(const AnchorList& anchors, std::size_t left_out) const {
  const auto componentOf = [&](const Anchor& anchor) {
    return mesh_->components()[nearestNodeBlend(*mesh_, anchor.in_blueprint).nodes[0]];
  };
  AnchorList others = anchors;
  others[left_out].enabled = false;
  const Result<Similarity2> fit_of_others = fitGlobally(others, {ScaleRule::kFixed, global_fit_.scale});
  const Similarity2& fit = fit_of_others ? *fit_of_others : global_fit_;
  const Vector2d by_fit = fit * anchors[left_out].in_blueprint;
  Vector2d shift = Vector2d::Zero();
  double count = 0.0;
  for (const Anchor& other : others) {
    if (!other.enabled || componentOf(other) != componentOf(anchors[left_out])) continue;
    shift += other.in_slam - fit * other.in_blueprint;
    count += 1.0;
  }
  return count > 0.0 ? Vector2d(by_fit + shift / count) : by_fit;
}

/// Residuals, and leave-one-out residuals from the one factorisation: without anchor c the minimum moves by
/// (J^T W J)^-1 J_c^T w (I - w G_cc)^-1 e_c with G = J (J^T W J)^-1 J^T, to first order (DESIGN.md section 3).
void MeshSolver::Impl::diagnoseAnchors(const AnchorList& anchors, Solution& solution) {
  // In the stretch model an anchor is tied to the very blend that predicts it; in the rigid model to its nearest node.
  const bool is_tied_to_prediction = objective_.unknowns == kStretchUnknowns;
  std::vector<NormalMatrix::SparseColumns> derivatives;
  for (const Anchor& anchor : anchors) {
    if (!anchor.enabled) continue;
    const AnchorTerm prediction = predictionAt(anchor.in_blueprint, anchor.in_slam);
    derivatives.push_back(derivativeColumns(objective_, objective_.anchors[derivatives.size()],
                                            is_tied_to_prediction ? nullptr : &prediction, x_.data()));
  }
  const std::vector<Eigen::Matrix4d> grams = normal_.inverseForms(derivatives);
  double whitened = 0.0;
  std::size_t determined = 0;
  std::size_t term = 0;
  for (std::size_t i = 0; i < anchors.size(); ++i) {
    const Anchor& anchor = anchors[i];
    AnchorFit fit;
    fit.id = anchor.id;
    fit.used = anchor.enabled;
    if (!anchor.enabled && !isActive(anchor.in_blueprint)) {
      fit.predicted = fit.predicted_without = global_fit_ * anchor.in_blueprint;
      fit.residual_m = fit.leave_one_out_m = (fit.predicted - anchor.in_slam).norm();
      solution.anchors.push_back(fit);
      continue;
    }
    const AnchorTerm prediction = predictionAt(anchor.in_blueprint, anchor.in_slam);
    const Vector2d residual = residualOf(objective_, prediction, x_.data());
    fit.predicted = fit.predicted_without = anchor.in_slam + residual;
    fit.residual_m = fit.leave_one_out_m = residual.norm();
    if (anchor.enabled) {
      const Eigen::Matrix4d& gram = grams[term];
      const AnchorTerm& used = objective_.anchors[term++];
      const Vector2d used_residual = residualOf(objective_, used, x_.data());
      fit.loss_weight = lossWeight(used_residual.squaredNorm(), objective_.loss_width_m);
      const double weight = objective_.anchor_information * fit.loss_weight;
      const Matrix2d remaining = Matrix2d::Identity() - weight * gram.topLeftCorner<2, 2>();
      if (Eigen::SelfAdjointEigenSolver<Matrix2d>(remaining).eigenvalues().x() > kNothingElse) {
        const Vector2d pushed = remaining.inverse() * used_residual;
        const Matrix2d across = is_tied_to_prediction ? gram.topLeftCorner<2, 2>() : gram.bottomLeftCorner<2, 2>();
        fit.predicted_without = fit.predicted + across * (weight * pushed);
        whitened += weight * pushed.dot(remaining * pushed);
        ++determined;
      } else {
        fit.predicted_without = predictedByFewOthers(anchors, i);
      }
      fit.leave_one_out_m = (fit.predicted_without - anchor.in_slam).norm();
      ++solution.anchors_used;
    }
    solution.anchors.push_back(fit);
  }
  variance_factor_ = whitened / (2.0 * static_cast<double>(std::max<std::size_t>(1, determined)));
}

tl::unexpected<Error> MeshSolver::Impl::tooLarge() const {
  return fail(ErrorCode::kInternal,
              "the mesh of " + std::to_string(mesh_->nodeCount()) +
                  " nodes is too large for the memory of this computer; choose a larger cell size");
}

void MeshSolver::Impl::addComponentWarning(Solution& solution) const {
  std::vector<bool> held(mesh_->componentCount(), false);
  for (const NodeIndex node : objective_.active_nodes) held[mesh_->components()[node]] = true;
  std::size_t free_components = 0;
  for (const bool is_held : held) free_components += is_held ? 0 : 1;
  if (free_components == 0) return;
  const std::size_t free_nodes = mesh_->nodeCount() - objective_.nodeCount();
  solution.warnings.push_back(
      plural(free_components, "part", "parts") + " of the free space (" + plural(free_nodes, "node", "nodes") +
      (free_components == 1 ? ") is not connected to any anchor and only follows the global fit."
                            : ") are not connected to any anchor and only follow the global fit."));
}

std::vector<double> MeshSolver::Impl::projectionSigma(const std::vector<Vector2d>& points) const {
  std::vector<double> sigmas(points.size(), kNaN);
  if (!std::isfinite(variance_factor_)) return sigmas;
  std::vector<std::size_t> known;
  std::vector<NormalMatrix::SparseColumns> derivatives;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!points[i].allFinite() || !isActive(points[i])) continue;
    known.push_back(i);
    derivatives.push_back(derivativeColumns(objective_, predictionAt(points[i], Vector2d::Zero()), nullptr, x_.data()));
  }
  const std::vector<Eigen::Matrix4d> grams = normal_.inverseForms(derivatives);
  for (std::size_t k = 0; k < known.size(); ++k) {
    const std::size_t i = known[k];
    const Eigen::Matrix4d& gram = grams[k];
    sigmas[i] = std::sqrt(0.5 * variance_factor_ * gram.topLeftCorner<2, 2>().trace());
    // Mesh and plate see the same anchors: their errors are taken as fully dependent.
    if (plate_) sigmas[i] = (1.0 - plate_share_) * sigmas[i] + plate_share_ * plate_->sigma(points[i]);
  }
  return sigmas;
}

MeshSolver::MeshSolver(std::shared_ptr<const Mesh> mesh, SolverBackend backend)
    : impl_(std::make_unique<Impl>(std::move(mesh), backend)) {}
MeshSolver::~MeshSolver() = default;
MeshSolver::MeshSolver(MeshSolver&&) noexcept = default;
MeshSolver& MeshSolver::operator=(MeshSolver&&) noexcept = default;

const Mesh& MeshSolver::mesh() const {
  return impl_->mesh();
}
Result<Solution> MeshSolver::solve(const AnchorList& anchors, const SolverSettings& settings,
                                   const Solution* warm_start, const IterationCallback& on_iteration) {
  return impl_->solve(anchors, settings, warm_start, on_iteration);
}
std::vector<double> MeshSolver::projectionSigma(const std::vector<Eigen::Vector2d>& points_in_blueprint) const {
  return impl_->projectionSigma(points_in_blueprint);
}

}  // namespace cad2slam
