// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/services/solve_worker.h"

#include "cad2slam/anchors/anchor_checks.h"
#include "cad2slam/mesh/mesh_builder.h"
#include "cad2slam/projection/make_projector.h"

#include <Eigen/LU>

#include <algorithm>
#include <chrono>
#include <limits>
#include <utility>

namespace cad2slam {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kPreviewNodes = 700;      // solves in a few milliseconds, so that a drag feels live
constexpr std::size_t kBenchCount = 4;  // full and preview of the SLAM map at hand and of the one before

bool sameMesh(const SolveRequest& a, const SolveRequest& b) {
  return a.blueprint == b.blueprint && a.cell_size_m == b.cell_size_m && a.quality == b.quality;
}

Result<void> check(const SolveRequest& request) {
  return checkAnchors(request.anchors, {.blueprint = request.blueprint->frame(), .slam = request.slam_frame});
}

Result<SolveResultPtr> resultOf(const SolveRequest& request, const std::shared_ptr<const Mesh>& mesh, Solution solution,
                                Clock::time_point begin) {
  Result<Projector> projector = makeProjector(*mesh, solution);
  if (!projector) return failAs(projector);
  std::vector<NodeIndex> folded;
  for (NodeIndex node = 0; projector->foldedTileCount() > 0 && node < mesh->nodeCount(); ++node)
    if (projector->jacobian(mesh->centers()[node]).determinant() <= 0.0) folded.push_back(node);
  const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  return std::make_shared<const SolveResult>(
      SolveResult{request.revision, request.map, request.quality, request.settings, request.cell_size_m,
                  request.anchors, mesh, std::move(solution), std::move(*projector), std::move(folded), seconds});
}

}  // namespace

struct SolveWorker::Bench {
  SolveRequest request;  // the last one solved here, or about to be
  std::shared_ptr<const Mesh> mesh;
  MeshSolver solver;
  std::optional<Solution> last;
};

SolveWorker::SolveWorker() = default;
SolveWorker::~SolveWorker() = default;

Result<std::shared_ptr<const Mesh>> SolveWorker::meshFor(const SolveRequest& request) const {
  for (const Bench& bench : benches_)
    if (sameMesh(bench.request, request)) return bench.mesh;
  std::optional<double> cell_size = request.cell_size_m;
  if (request.quality == Quality::kPreview) {
    const double coarse = automaticCellSize(*request.blueprint, kPreviewNodes);
    cell_size = std::max(coarse, cell_size.value_or(automaticCellSize(*request.blueprint)));
  }
  Result<Mesh> mesh = buildMesh(*request.blueprint, cell_size);
  if (!mesh) return failAs(mesh);
  return std::make_shared<const Mesh>(std::move(*mesh));
}

Result<SolveWorker::Bench*> SolveWorker::benchFor(const SolveRequest& request) {
  const auto found = std::find_if(benches_.begin(), benches_.end(), [&](const Bench& bench) {
    return sameMesh(bench.request, request) && bench.request.map == request.map;
  });
  if (found != benches_.end()) {
    benches_.splice(benches_.begin(), benches_, found);
  } else {
    Result<std::shared_ptr<const Mesh>> mesh = meshFor(request);
    if (!mesh) return failAs(mesh);
    // A mesh of another size is not coming back soon, and a factor takes tens of megabytes.
    benches_.remove_if([&](const Bench& bench) {
      return bench.request.map == request.map && bench.request.quality == request.quality;
    });
    while (benches_.size() >= kBenchCount) benches_.pop_back();
    benches_.push_front(Bench{request, *mesh, MeshSolver(*mesh), std::nullopt});
  }
  return &benches_.front();
}

Result<SolveResultPtr> SolveWorker::solve(const SolveRequest& request, const IterationCallback& on_iteration) {
  const auto begin = Clock::now();
  const Result<void> checked = check(request);
  if (!checked) return failAs(checked);
  Result<Bench*> bench = benchFor(request);
  if (!bench) return failAs(bench);
  Bench& at = **bench;
  const bool same_model = at.last && at.last->settings.model == request.settings.model;
  Result<Solution> solution =
      at.solver.solve(request.anchors, request.settings, same_model ? &*at.last : nullptr, on_iteration);
  if (!solution && solution.error().code == ErrorCode::kNotConverged && same_model)
    solution = at.solver.solve(request.anchors, request.settings, nullptr, on_iteration);
  if (!solution) {
    at.last.reset();
    return failAs(solution);
  }
  Result<SolveResultPtr> result = resultOf(request, at.mesh, *solution, begin);
  if (result) {
    at.request = request;
    at.last = std::move(*solution);
  }
  return result;
}

Result<SolveResultPtr> SolveWorker::solveAside(const SolveRequest& request,
                                               const IterationCallback& on_iteration) const {
  const auto begin = Clock::now();
  const Result<void> checked = check(request);
  if (!checked) return failAs(checked);
  const Result<std::shared_ptr<const Mesh>> mesh = meshFor(request);
  if (!mesh) return failAs(mesh);
  MeshSolver solver(*mesh);
  Result<Solution> solution = solver.solve(request.anchors, request.settings, nullptr, on_iteration);
  if (!solution) return failAs(solution);
  return resultOf(request, *mesh, std::move(*solution), begin);
}

double SolveWorker::sigma(const std::string& map, const Eigen::Vector2d& point_in_blueprint) const {
  for (const Bench& bench : benches_) {
    if (bench.request.map != map || bench.request.quality != Quality::kFull || !bench.last) continue;
    const std::vector<double> sigmas = bench.solver.projectionSigma({point_in_blueprint});
    if (!sigmas.empty()) return sigmas.front();
  }
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace cad2slam
