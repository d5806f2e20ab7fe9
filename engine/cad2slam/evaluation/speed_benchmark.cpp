// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/evaluation/speed_benchmark.h"

#include "cad2slam/mesh/mesh_builder.h"
#include "cad2slam/projection/make_projector.h"
#include "cad2slam/simulation/seeded_random.h"

#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <vector>

namespace cad2slam {
namespace {

using Clock = std::chrono::steady_clock;

double millisecondsSince(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// Poses all over the tiles of a mesh.
std::vector<Pose2> randomPoses(const Mesh& mesh, int count, SeededRandom& random) {
  std::vector<Pose2> poses;
  const double half = 0.5 * mesh.lattice().cell_size;
  const auto last = static_cast<int>(mesh.nodeCount()) - 1;
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector2d& center = mesh.centers()[static_cast<std::size_t>(random.integer(0, last))];
    const Eigen::Vector2d offset(random.uniform(-half, half), random.uniform(-half, half));
    poses.push_back({center + offset, random.uniform(-kPi, kPi)});
  }
  return poses;
}

/// Time of one query for each pose [us]. Each is repeated, as one alone is near the resolution of the clock.
template <class Query>
ErrorStatistics timeQueries(const std::vector<Pose2>& poses, const Query& query) {
  constexpr int kRepetitions = 64;
  std::vector<double> microseconds;
  double unused = 0.0;
  for (const Pose2& pose : poses) {
    const Clock::time_point start = Clock::now();
    for (int i = 0; i < kRepetitions; ++i) unused += query(pose).pose.heading;
    microseconds.push_back(1e3 * millisecondsSince(start) / kRepetitions);
  }
  volatile double keep = unused;  // the queries must not be optimised away
  static_cast<void>(keep);
  return summarise(std::move(microseconds));
}

double peakMemoryBytes() {
  rusage usage{};
  return getrusage(RUSAGE_SELF, &usage) == 0 ? 1024.0 * static_cast<double>(usage.ru_maxrss) : 0.0;
}

void measureProjector(const Projector& projector, const Mesh& mesh, const SpeedOptions& options, SpeedReport& report) {
  SeededRandom random(options.seed);
  const std::vector<Pose2> poses = randomPoses(mesh, options.poses, random);
  std::vector<Pose2> in_slam;
  for (const Pose2& pose : poses) {
    const Projection projected = projector.slamFromBlueprint(pose, OutsidePolicy::kRigid);
    if (projected.ok()) in_slam.push_back(projected.pose);
  }
  report.projection_us =
      timeQueries(poses, [&](const Pose2& pose) { return projector.slamFromBlueprint(pose, OutsidePolicy::kRigid); });
  report.inverse_us =
      timeQueries(in_slam, [&](const Pose2& pose) { return projector.blueprintFromSlam(pose, OutsidePolicy::kRigid); });

  const std::vector<Pose2> batch = randomPoses(mesh, options.batch_poses, random);
  std::vector<Projection> answers(batch.size());
  Clock::time_point start = Clock::now();
  projector.slamFromBlueprint(batch.data(), answers.data(), batch.size(), OutsidePolicy::kRigid, options.threads);
  report.batch_projections_per_s = 1e3 * static_cast<double>(batch.size()) / millisecondsSince(start);
  std::vector<Pose2> back;
  for (const Projection& answer : answers) back.push_back(answer.pose);
  start = Clock::now();
  projector.blueprintFromSlam(back.data(), answers.data(), back.size(), OutsidePolicy::kRigid, options.threads);
  report.batch_inverses_per_s = 1e3 * static_cast<double>(back.size()) / millisecondsSince(start);
}

}  // namespace

Result<SpeedReport> measureSpeed(const OccupancyGrid& blueprint, const AnchorList& anchors,
                                 const SpeedOptions& options) {
  if (options.repetitions < 1 || options.poses < 1 || options.batch_poses < 1) {
    return fail(ErrorCode::kOutOfDomain, "Measuring speed needs at least one repetition and one pose");
  }
  SpeedReport report;
  std::vector<double> construction;
  std::vector<double> optimisation;
  std::vector<double> again;
  std::shared_ptr<const Mesh> mesh;
  std::optional<Solution> solution;
  for (int i = 0; i < options.repetitions; ++i) {
    Clock::time_point start = Clock::now();
    Result<Mesh> built = buildMesh(blueprint, options.cell_size_m);
    if (!built) return failAs(built);
    construction.push_back(millisecondsSince(start));
    mesh = std::make_shared<const Mesh>(std::move(*built));

    start = Clock::now();
    MeshSolver solver(mesh);
    Result<Solution> solved = solver.solve(anchors, options.settings);
    if (!solved) return failAs(solved);
    optimisation.push_back(millisecondsSince(start));

    AnchorList edited = anchors;
    edited.front().in_slam += Eigen::Vector2d(0.1, -0.1);
    start = Clock::now();
    if (solver.solve(edited, options.settings, &*solved)) again.push_back(millisecondsSince(start));
    solution = std::move(*solved);
  }
  const Result<Projector> projector = makeProjector(*mesh, *solution);
  if (!projector) return failAs(projector);
  report.nodes = mesh->nodeCount();
  report.edges = mesh->edges().size();
  report.anchors = solution->anchors_used;
  report.construction_ms = summarise(std::move(construction));
  report.optimisation_ms = summarise(std::move(optimisation));
  report.again_ms = summarise(std::move(again));
  constexpr std::size_t kBytesPerNode = 7 * sizeof(double) + 2 * sizeof(std::int32_t);
  report.projector_bytes = static_cast<double>(report.nodes * kBytesPerNode);
  measureProjector(*projector, *mesh, options, report);
  report.peak_memory_bytes = peakMemoryBytes();
  return report;
}

}  // namespace cad2slam
