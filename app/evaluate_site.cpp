// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "app/evaluate_site.h"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <utility>

#include "cad2slam/anchors/anchor_checks.h"
#include "cad2slam/io/map_file.h"
#include "cad2slam/mesh/mesh_builder.h"

namespace cad2slam::cli {
namespace {

Result<void> applyOptions(const EvaluateOptions& options, SolveInputs& inputs) {
  if (inputs.settings.model != Model::kStretch || options.project.empty()) {
    const ScaleSettings scale = inputs.settings.scale;
    inputs.settings = defaultSettings(Model::kStretch);
    if (!options.project.empty()) inputs.settings.scale = scale;
  }
  if (Result<void> done = applyScaleAndCells(options.scale, options.cell_size, inputs); !done) return done;
  return applyOverrides(options.overrides, inputs.settings);
}

}  // namespace

Result<void> applyOverrides(const std::vector<std::string>& overrides, SolverSettings& settings) {
  for (const std::string& text : overrides) {
    const std::size_t equals = text.find('=');
    const std::string name = text.substr(0, equals);
    const Result<double> value = positiveNumber(equals == std::string::npos ? "" : text.substr(equals + 1), text);
    if (!value) return failAs(value);
    if (name == "lambda_x") {
      settings.lambda_x = *value;
    } else if (name == "lambda_y") {
      settings.lambda_y = *value;
    } else if (name == "lambda_theta") {
      settings.lambda_theta = *value;
    } else if (name == "lambda_stretch") {
      settings.lambda_stretch = *value;
    } else if (name == "prior_strength") {
      settings.prior_strength = *value;
    } else if (name == "anchor_information") {
      settings.anchor_information = *value;
    } else if (name == "loss_width_m") {
      settings.loss_width_m = *value;
    } else {
      return fail(ErrorCode::kOutOfDomain, "there is no weight of this name", "--set " + name);
    }
    settings.stiffness = Stiffness::kGiven;  // or the weight would be chosen again
  }
  return {};
}

void addRunOptions(CLI::App& command, const std::shared_ptr<EvaluateOptions>& options) {
  command.add_option("--cell-size", options->cell_size, "Edge length of a mesh cell in metres, or auto");
  command.add_option("--set", options->overrides, "Weight of the stretch model, NAME=VALUE, for experiments");
  command.add_option("--threads", options->threads, "How many threads work (default: one for each core)");
  command.add_option("--seed", options->seed, "Seed of everything random")->capture_default_str();
  command.add_flag("--json", options->json, "Print the report as one JSON object");
  command.add_option("--csv", options->csv, "Also write the table to this CSV file");
}

void addSiteOptions(CLI::App& command, const std::shared_ptr<EvaluateOptions>& options) {
  addRunOptions(command, options);
  CLI::Option* project = command.add_option("project", options->project, "Project file (.c2sproj)");
  command.add_option("--map", options->map, "Which SLAM map of the project")->needs(project);
  CLI::Option* blueprint = command.add_option("--blueprint", options->blueprint, "Blueprint (map_server YAML)");
  CLI::Option* slam = command.add_option("--slam", options->slam, "SLAM map (map_server YAML)");
  CLI::Option* anchors =
      command.add_option("--anchors", options->anchors, "Anchors (CSV, or .data of the paper's authors)");
  blueprint->needs(slam)->needs(anchors)->excludes(project);
  slam->needs(blueprint)->excludes(project);
  anchors->needs(blueprint)->excludes(project);
  command.add_option(
      "--scale", options->scale,
      "auto: the plan claims to be to scale; unknown: least squares; or SLAM metres per blueprint metre");
}

void requireSite(const EvaluateOptions& options) {
  if (options.project.empty() && options.blueprint.empty()) {
    throw CLI::RequiredError("evaluate: a project, or --blueprint, --slam and --anchors,");
  }
}

Result<EvaluationSite> loadSite(const EvaluateOptions& options) {
  Result<SolveInputs> inputs = options.project.empty()
                                   ? inputsFromFiles(options.blueprint, options.slam, options.anchors)
                                   : inputsFromProject(options.project, options.map);
  if (!inputs) return failAs(inputs);
  if (Result<void> applied = applyOptions(options, *inputs); !applied) return failAs(applied);
  const auto start = std::chrono::steady_clock::now();
  Result<LoadedMap> map = loadMap(inputs->blueprint, {inputs->semantics});
  if (!map) return failAs(map);
  const Result<MapFrame> slam_frame = readMapFrame(inputs->slam);
  if (!slam_frame) return failAs(slam_frame);
  if (Result<void> usable = checkAnchors(inputs->anchors, {map->grid.frame(), *slam_frame}); !usable) {
    return failAs(usable);
  }
  const std::chrono::duration<double> loading = std::chrono::steady_clock::now() - start;
  Result<Mesh> mesh = buildMesh(map->grid, inputs->cell_size_m);
  if (!mesh) return fail(mesh.error().code, mesh.error().message, inputs->blueprint.image.string());
  EvaluationSite site{
      std::move(*inputs), map->grid, std::make_shared<const Mesh>(std::move(*mesh)), loading.count(), {}};
  site.warnings = site.inputs.warnings;
  site.warnings.insert(site.warnings.end(), map->warnings.begin(), map->warnings.end());
  return site;
}

Result<OccupancyGrid> loadSlamGrid(const EvaluationSite& site) {
  Result<LoadedMap> map = loadMap(site.inputs.slam, {site.inputs.semantics});
  if (!map) return failAs(map);
  return map->grid;
}

EvaluationOptions evaluationOptions(const EvaluateOptions& options, const EvaluationSite& site,
                                    const std::string& what) {
  EvaluationOptions evaluation;
  evaluation.stretch = site.inputs.settings;
  evaluation.threads = options.threads;
  evaluation.on_progress = progressBar(what);
  return evaluation;
}

ProgressCallback progressBar(const std::string& what) {
  if (isatty(STDERR_FILENO) == 0) return {};
  return [what, shown = std::size_t{0}](std::size_t done, std::size_t total) mutable {
    constexpr std::size_t kWidth = 40;
    const std::size_t filled = kWidth * done / std::max<std::size_t>(total, 1);
    if (done != total && filled == shown) return;
    shown = filled;
    const std::string bar =
        done == total ? "\r\033[K"
                      : fmt::format("\r{} [{:<{}}] {} of {}", what, std::string(filled, '='), kWidth, done, total);
    std::fputs(bar.c_str(), stderr);
    std::fflush(stderr);
  };
}

}  // namespace cad2slam::cli
