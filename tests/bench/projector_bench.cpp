// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include <benchmark/benchmark.h>
#include <unistd.h>

#include <filesystem>
#include <opencv2/core.hpp>
#include <optional>
#include <random>
#include <utility>

#include "bench/corridor_building.h"
#include "bench/peak_memory.h"
#include "cad2slam/io/projector_file.h"
#include "cad2slam/projection/projector.h"
#include "cad2slam/projection/raster_warper.h"

/// Queries of projectors over office buildings of 1k to 1M nodes, their files, and warps of whole rasters.
namespace cad2slam::bench {
namespace {

constexpr std::size_t kPoses = 50'000;

enum class Places { kPath, kRandom };

/// A robot that drives through corridors and rooms at 2 cm a step, or places all over the building.
std::vector<Pose2> posesOn(const ProjectorData& data, Places places) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  const TileLattice& lattice = data.info.lattice;
  std::vector<Pose2> poses;
  if (places == Places::kRandom) {
    while (poses.size() < kPoses) {
      const TileCoordinate tile = data.node_tile[random() % data.node_tile.size()];
      poses.push_back(
          {lattice.blueprintFromCells({tile.column + part(random), tile.row + part(random)}), 6.28 * part(random)});
    }
    return poses;
  }
  const double side = std::min(extentOf(data.node_tile, lattice.cell_size), 160.0);
  Pose2 robot{{0.5, 1.5}, 0.2};
  while (poses.size() < kPoses) {
    const Eigen::Vector2d next = robot.translation + rotationMatrix(robot.heading) * Eigen::Vector2d(0.02, 0.0);
    const Eigen::Vector2d cells = lattice.cellsFromBlueprint(next);
    const bool free = next.minCoeff() > 0.0 && next.maxCoeff() < side - 3.0 &&
                      isFreeTile(static_cast<std::int32_t>(cells.x()), static_cast<std::int32_t>(cells.y()));
    if (!free) {
      robot.heading += 1.9;
      continue;
    }
    robot.translation = next;
    poses.push_back(robot);
  }
  return poses;
}

struct Case {
  Projector projector;
  std::vector<Pose2> in_blueprint;
  std::vector<Pose2> in_slam;
};

/// The benchmark library calls a benchmark several times while it looks for a number of iterations: the last case is
/// kept.
const Case& caseOf(std::int64_t nodes, Places places) {
  static std::optional<Case> last;
  static std::pair<std::int64_t, Places> last_key;
  if (last && last_key == std::pair(nodes, places)) return *last;
  last.reset();
  const ProjectorData data = officeProjector(static_cast<std::size_t>(nodes));
  last = Case{*Projector::create(data), posesOn(data, places), {}};
  last_key = {nodes, places};
  for (const Pose2& pose : last->in_blueprint) {
    last->in_slam.push_back(last->projector.slamFromBlueprint(pose, OutsidePolicy::kRigid).pose);
  }
  (void)last->projector.foldedTileCount();  // counted once, at the first inverse
  return *last;
}

void forward(benchmark::State& state, Places places) {
  const Case& made = caseOf(state.range(0), places);
  std::size_t at = 0;
  for (auto step : state) {
    benchmark::DoNotOptimize(made.projector.slamFromBlueprint(made.in_blueprint[at], OutsidePolicy::kError));
    if (++at == kPoses) at = 0;
  }
}

void inverse(benchmark::State& state, Places places) {
  const Case& made = caseOf(state.range(0), places);
  std::size_t at = 0;
  for (auto step : state) {
    benchmark::DoNotOptimize(made.projector.blueprintFromSlam(made.in_slam[at], OutsidePolicy::kError));
    if (++at == kPoses) at = 0;
  }
}

void batch(benchmark::State& state, bool to_slam) {
  const Case& made = caseOf(state.range(0), Places::kRandom);
  std::vector<Projection> out(kPoses);
  for (auto step : state) {
    if (to_slam) {
      made.projector.slamFromBlueprint(made.in_blueprint.data(), out.data(), kPoses, OutsidePolicy::kError, 2);
    } else {
      made.projector.blueprintFromSlam(made.in_slam.data(), out.data(), kPoses, OutsidePolicy::kError, 2);
    }
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(kPoses));
}

void load(benchmark::State& state) {
  const std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("projector_bench_" + std::to_string(getpid()) + ".c2s");
  if (const Result<void> written = writeProjectorFile(path, officeProjector(static_cast<std::size_t>(state.range(0))));
      !written) {
    return state.SkipWithError(written.error().sentence().c_str());
  }
  const auto file_size = static_cast<double>(std::filesystem::file_size(path));
  double peak = 0.0;
  double kept = 0.0;
  for (auto step : state) {
    state.PauseTiming();
    resetPeakMemory();
    const double before = memoryBytes("VmRSS");
    state.ResumeTiming();
    const Result<Projector> projector = loadProjector(path);
    state.PauseTiming();
    if (!projector) state.SkipWithError(projector.error().sentence().c_str());
    peak = std::max(peak, memoryBytes("VmHWM") - before);
    kept = std::max(kept, memoryBytes("VmRSS") - before);
    state.ResumeTiming();
  }
  std::filesystem::remove(path);
  state.counters["file_MB"] = file_size / 1e6;
  state.counters["peak_of_file"] = peak / file_size;
  state.counters["kept_of_file"] = kept / file_size;
}

/// A blueprint of 4000 x 2000 px at 5 cm per pixel over cells of 2 m.
void warp(benchmark::State& state, WarpDirection direction) {
  const auto height = static_cast<int>(state.range(0));
  const Projector projector = *Projector::create(officeProjector(static_cast<std::size_t>(height) * 2, 2.0));
  const cv::Mat picture(height, 2 * height, CV_8UC1, cv::Scalar(254));
  const MapFrame blueprint = *MapFrame::create(0.05, 2 * height, height, {});
  const MapFrame slam = *warpedExtent(projector, WarpDirection::kToSlam, blueprint, 0.05);
  cv::Mat slam_picture(slam.height(), slam.width(), CV_8UC1, cv::Scalar(254));
  const bool to_slam = direction == WarpDirection::kToSlam;
  for (auto step : state) {
    const Result<cv::Mat> warped = to_slam ? warpRaster(projector, direction, picture, blueprint, slam)
                                           : warpRaster(projector, direction, slam_picture, slam, blueprint);
    if (!warped) return state.SkipWithError(warped.error().sentence().c_str());
    benchmark::DoNotOptimize(warped->data);
  }
  state.counters["out_Mpx"] =
      (to_slam ? slam.width() * static_cast<double>(slam.height()) : 2.0 * height * height) / 1e6;
}

void sizes(benchmark::internal::Benchmark* bench) {
  for (const int nodes : {1000, 10'000, 100'000, 1'000'000}) bench->Arg(nodes);
}

void onTwoCores(benchmark::internal::Benchmark* bench) {
  sizes(bench);
  bench->UseRealTime()->MeasureProcessCPUTime();
}

BENCHMARK_CAPTURE(forward, path, Places::kPath)->Apply(sizes);
BENCHMARK_CAPTURE(forward, random, Places::kRandom)->Apply(sizes);
BENCHMARK_CAPTURE(inverse, path, Places::kPath)->Apply(sizes);
BENCHMARK_CAPTURE(inverse, random, Places::kRandom)->Apply(sizes);
BENCHMARK_CAPTURE(batch, forward, true)->Apply(onTwoCores);
BENCHMARK_CAPTURE(batch, inverse, false)->Apply(onTwoCores);
BENCHMARK(load)->Apply(sizes)->Unit(benchmark::kMillisecond)->UseRealTime()->MeasureProcessCPUTime();
BENCHMARK_CAPTURE(warp, to_slam, WarpDirection::kToSlam)
    ->Arg(1000)
    ->Arg(2000)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->MeasureProcessCPUTime();
BENCHMARK_CAPTURE(warp, to_blueprint, WarpDirection::kToBlueprint)
    ->Arg(1000)
    ->Arg(2000)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->MeasureProcessCPUTime();

}  // namespace
}  // namespace cad2slam::bench

BENCHMARK_MAIN();
