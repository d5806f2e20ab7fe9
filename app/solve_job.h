// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cad2slam/anchors/anchor.h"
#include "cad2slam/core/result.h"
#include "cad2slam/io/map_file.h"
#include "cad2slam/mesh/mesh.h"
#include "cad2slam/projection/projector_data.h"
#include "cad2slam/solver/mesh_solver.h"
#include "cad2slam/solver/solution.h"

namespace cad2slam::cli {

/// What is to be solved, whether it came from options or from a project file.
struct SolveInputs {
  MapMetadata blueprint;
  MapMetadata slam;
  std::string slam_name;
  std::string project;  ///< file name of the project, or empty
  AnchorList anchors;
  SolverSettings settings;
  std::optional<double> cell_size_m;
  MapSemantics semantics = MapSemantics::kJazzy;
  std::vector<std::string> warnings;
};

struct JobSeconds {
  double load = 0.0;
  double mesh = 0.0;
  double solve = 0.0;
  double write = 0.0;
};

struct SolvedJob {
  std::shared_ptr<const Mesh> mesh;
  Solution solution;
  FrameInfo blueprint;
  FrameInfo slam;
  JobSeconds seconds;
  std::vector<std::string> warnings;  ///< of files, maps and solver
};

/// Reads the anchors and both YAML files that options name.
[[nodiscard]] Result<SolveInputs> inputsFromFiles(const std::filesystem::path& blueprint,
                                                  const std::filesystem::path& slam,
                                                  const std::filesystem::path& anchors);
/// Takes one SLAM map of a project; `map` may be empty when there is only one.
[[nodiscard]] Result<SolveInputs> inputsFromProject(const std::filesystem::path& project, const std::string& map);

/// Of the option of this name, which is named in complaints.
[[nodiscard]] Result<double> positiveNumber(const std::string& text, const std::string& option);
/// --scale (auto, unknown or SLAM metres per blueprint metre) and --cell-size (auto or metres); empty texts leave what
/// is there.
[[nodiscard]] Result<void> applyScaleAndCells(const std::string& scale, const std::string& cell_size,
                                              SolveInputs& inputs);

/// Loads the blueprint, builds the mesh and solves. `on_iteration` may be empty.
[[nodiscard]] Result<SolvedJob> runSolve(const SolveInputs& inputs, SolverBackend backend,
                                         const IterationCallback& on_iteration);

/// Now in ISO 8601 UTC; the time of SOURCE_DATE_EPOCH where that is set.
[[nodiscard]] std::string creationTime();

}  // namespace cad2slam::cli
