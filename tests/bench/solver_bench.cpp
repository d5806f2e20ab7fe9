// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include <benchmark/benchmark.h>

#include "bench/corridor_building.h"
#include "bench/peak_memory.h"
#include "cad2slam/solver/blas_kernels.h"
#include "cad2slam/solver/mesh_solver.h"

/// Solves office buildings of 1k to 100k nodes with 50 anchors. Names: model, backend, nodes.
namespace cad2slam::bench {
namespace {

constexpr std::size_t kAnchors = 50;

void report(benchmark::State& state, const Solution& solution, double memory_before) {
  state.counters["iterations"] = solution.iterations;
  state.counters["gradient"] = solution.relative_gradient;
  state.counters["order_s"] = solution.seconds.ordering;
  state.counters["optimise_s"] = solution.seconds.optimisation;
  state.counters["diagnose_s"] = solution.seconds.diagnosis;
  state.counters["peak_MB"] = (memoryBytes("VmHWM") - memory_before) / 1e6;
}

void coldSolve(benchmark::State& state, Model model, SolverBackend backend) {
  const auto mesh = officeMesh(static_cast<std::size_t>(state.range(0)));
  const AnchorList anchors = officeAnchors(*mesh, kAnchors);
  resetPeakMemory();
  const double memory_before = memoryBytes("VmRSS");
  Solution last;
  for (auto step : state) {
    Result<Solution> solution = MeshSolver(mesh, backend).solve(anchors, defaultSettings(model));
    if (!solution) return state.SkipWithError(solution.error().sentence().c_str());
    last = std::move(*solution);
  }
  report(state, last, memory_before);
}

/// One anchor is dragged to and fro by 30 cm.
void warmSolve(benchmark::State& state, Model model, SolverBackend backend) {
  const auto mesh = officeMesh(static_cast<std::size_t>(state.range(0)));
  AnchorList anchors = officeAnchors(*mesh, kAnchors);
  MeshSolver solver(mesh, backend);
  Result<Solution> last = solver.solve(anchors, defaultSettings(model));
  if (!last) return state.SkipWithError(last.error().sentence().c_str());
  resetPeakMemory();
  const double memory_before = memoryBytes("VmRSS");
  Eigen::Vector2d drag(0.3, -0.1);
  for (auto step : state) {
    anchors[7].in_slam += drag;
    drag = -drag;
    Result<Solution> next = solver.solve(anchors, defaultSettings(model), &*last);
    if (!next) return state.SkipWithError(next.error().sentence().c_str());
    last = std::move(next);
  }
  report(state, *last, memory_before);
}

void sizes(benchmark::internal::Benchmark* bench) {
  for (const int nodes : {1000, 3752, 16'000, 64'000, 100'000}) bench->Arg(nodes);
  bench->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
}

BENCHMARK_CAPTURE(coldSolve, rigid_direct, Model::kRigid, SolverBackend::kDirect)->Apply(sizes);
BENCHMARK_CAPTURE(coldSolve, stretch_direct, Model::kStretch, SolverBackend::kDirect)->Apply(sizes);
BENCHMARK_CAPTURE(warmSolve, rigid_direct, Model::kRigid, SolverBackend::kDirect)->Apply(sizes);
BENCHMARK_CAPTURE(warmSolve, stretch_direct, Model::kStretch, SolverBackend::kDirect)->Apply(sizes);
BENCHMARK_CAPTURE(coldSolve, rigid_ceres, Model::kRigid, SolverBackend::kCeres)->Apply(sizes);
BENCHMARK_CAPTURE(coldSolve, stretch_ceres, Model::kStretch, SolverBackend::kCeres)->Apply(sizes);

}  // namespace
}  // namespace cad2slam::bench

int main(int argc, char** argv) {
  cad2slam::fitBlasToProcessor();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
