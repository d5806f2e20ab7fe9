// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cad2slam/anchors/anchor.h"
#include "cad2slam/core/result.h"
#include "cad2slam/map/map_frame.h"
#include "cad2slam/map/occupancy_grid.h"
#include "cad2slam/mesh/mesh.h"
#include "cad2slam/projection/projector.h"
#include "cad2slam/solver/solution.h"
#include "cad2slam/solver/solver_settings.h"

#include <QMetaType>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace cad2slam {

/// How much of the work a request is worth.
enum class Quality {
  kPreview,  ///< while a gesture goes on: larger cells
  kFull,
};

/// Everything a solve depends on, as values.
struct SolveRequest {
  std::uint64_t revision = 0;  ///< of the document
  std::string map;             ///< name of the SLAM map
  std::shared_ptr<const OccupancyGrid> blueprint;
  std::optional<MapFrame> slam_frame;  ///< empty: anchors are not checked against it
  AnchorList anchors;
  SolverSettings settings;
  std::optional<double> cell_size_m;
  Quality quality = Quality::kFull;
  bool preview_first = false;  ///< a result of Quality::kPreview comes before the full one
};

/// One solved state, immutable and complete: whoever holds it can draw, project and judge.
struct SolveResult {
  std::uint64_t revision = 0;
  std::string map;
  Quality quality = Quality::kFull;
  SolverSettings settings;            ///< as asked, unlike those of the solution
  std::optional<double> cell_size_m;  ///< as asked
  AnchorList anchors;                 ///< as they were when asked
  std::shared_ptr<const Mesh> mesh;
  Solution solution;
  Projector projector;
  std::vector<NodeIndex> folded_nodes;  ///< where the projection turns over
  double seconds = 0.0;                 ///< from the start of the work to its end, mesh included
};

using SolveResultPtr = std::shared_ptr<const SolveResult>;

/// Why a request has no result.
struct SolveFailure {
  std::uint64_t revision = 0;
  std::string map;
  Error error;
};

}  // namespace cad2slam

Q_DECLARE_METATYPE(cad2slam::SolveResultPtr)
Q_DECLARE_METATYPE(cad2slam::SolveFailure)
