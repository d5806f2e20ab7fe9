// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/solve_job.h"
#include "cad2slam/core/result.h"
#include "cad2slam/evaluation/anchor_errors.h"
#include "cad2slam/map/occupancy_grid.h"
#include "cad2slam/mesh/mesh.h"

namespace cad2slam::cli {

/// Options that all subcommands of `evaluate` share.
struct EvaluateOptions {
  std::string project;
  std::string map;
  std::string blueprint;
  std::string slam;
  std::string anchors;
  std::string scale;
  std::string cell_size;
  unsigned threads = 0;
  std::uint64_t seed = 1;
  bool json = false;
  std::string csv;                     ///< file to write, or empty
  std::vector<std::string> overrides;  ///< NAME=VALUE for weights of the stretch model
};

/// Options of `evaluate` that need no site.
void addRunOptions(CLI::App& command, const std::shared_ptr<EvaluateOptions>& options);
/// The same and those that say what to evaluate.
void addSiteOptions(CLI::App& command, const std::shared_ptr<EvaluateOptions>& options);

/// Throws CLI's usage error when options name nothing to evaluate.
void requireSite(const EvaluateOptions& options);

/// What is evaluated: one blueprint, one SLAM map, the anchors between them.
struct EvaluationSite {
  SolveInputs inputs;
  OccupancyGrid blueprint;
  std::shared_ptr<const Mesh> mesh;
  double load_seconds = 0.0;
  std::vector<std::string> warnings;
};

[[nodiscard]] Result<EvaluationSite> loadSite(const EvaluateOptions& options);
[[nodiscard]] Result<OccupancyGrid> loadSlamGrid(const EvaluationSite& site);

/// Changes weights by name, for experiments. kOutOfDomain names what is unknown or no number.
[[nodiscard]] Result<void> applyOverrides(const std::vector<std::string>& overrides, SolverSettings& settings);

/// Threads, settings and, on a terminal, a progress bar.
[[nodiscard]] EvaluationOptions evaluationOptions(const EvaluateOptions& options, const EvaluationSite& site,
                                                  const std::string& what);

/// A bar that rewrites itself on a terminal; empty elsewhere.
[[nodiscard]] ProgressCallback progressBar(const std::string& what);

}  // namespace cad2slam::cli
