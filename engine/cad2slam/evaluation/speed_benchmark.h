// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "cad2slam/anchors/anchor.h"
#include "cad2slam/core/result.h"
#include "cad2slam/evaluation/anchor_errors.h"
#include "cad2slam/evaluation/error_statistics.h"
#include "cad2slam/map/occupancy_grid.h"

namespace cad2slam {

struct SpeedOptions {
  SolverSettings settings = defaultSettings(Model::kStretch);
  std::optional<double> cell_size_m;
  int repetitions = 5;  ///< of construction and optimisation
  int poses = 1000;
  int batch_poses = 1'000'000;
  unsigned threads = 0;  ///< of the batch calls
  std::uint64_t seed = 1;
};

/// The columns of the paper's table IV and what it lacks, on this machine and now.
struct SpeedReport {
  std::size_t nodes = 0;
  std::size_t edges = 0;
  std::size_t anchors = 0;
  ErrorStatistics construction_ms{};
  ErrorStatistics optimisation_ms{};  ///< from nothing but the mesh: ordering, all iterations, residuals
  ErrorStatistics again_ms{};         ///< the same solver once more after an edit of one anchor, from its last solution
  ErrorStatistics projection_us{};    ///< of one pose, over the poses
  ErrorStatistics inverse_us{};
  double batch_projections_per_s = 0.0;
  double batch_inverses_per_s = 0.0;
  double projector_bytes = 0.0;    ///< size of its arrays
  double peak_memory_bytes = 0.0;  ///< of the whole process until now
};

[[nodiscard]] Result<SpeedReport> measureSpeed(const OccupancyGrid& blueprint, const AnchorList& anchors,
                                               const SpeedOptions& options);

}  // namespace cad2slam
