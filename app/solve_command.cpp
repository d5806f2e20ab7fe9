// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/cli_command.h"
#include "app/cli_options.h"
#include "app/solve_job.h"
#include "app/version.h"
#include "cad2slam/io/projector_file.h"
#include "cad2slam/projection/make_projector.h"

namespace cad2slam::cli {
namespace {

struct SolveOptions {
  std::string project;
  std::string map;
  std::string blueprint;
  std::string slam;
  std::string anchors;
  std::string model;
  std::optional<Stiffness> stiffness;
  std::string scale;
  std::string cell_size;
  std::string output;
  BlendWeights weights = BlendWeights::kSmooth;
  OutsidePolicy outside = OutsidePolicy::kError;
  MapSemantics semantics = MapSemantics::kJazzy;
  SolverBackend backend = SolverBackend::kDirect;
  double radius_m = 4.0;
  bool json = false;
  bool reproducible = false;
};

const Choices<Stiffness> kStiffnesses = {{"auto", Stiffness::kAutomatic},
                                         {"local", Stiffness::kLocal},
                                         {"smooth", Stiffness::kSmooth},
                                         {"loose", Stiffness::kLoose}};

std::string nameOf(Stiffness stiffness) {
  for (const auto& [name, value] : kStiffnesses) {
    if (value == stiffness) return name;
  }
  return "given";
}

std::string nameOf(const Solution& solution) {
  std::string name = nameOf(solution.settings.stiffness);
  if (solution.similarity_share > 0.0) name += fmt::format(", {:.0f} % similarity", 100.0 * solution.similarity_share);
  if (solution.plate_share > 0.0) name += fmt::format(", {:.0f} % thin plate", 100.0 * solution.plate_share);
  return name;
}

/// What the command line says beats what the project says.
Result<void> applyOverrides(const SolveOptions& options, SolveInputs& inputs) {
  inputs.semantics = options.semantics;
  if (!options.model.empty() || options.project.empty()) {
    inputs.settings = defaultSettings(options.model == "rigid" ? Model::kRigid : Model::kStretch);
  }
  if (options.stiffness && inputs.settings.model == Model::kStretch) inputs.settings.stiffness = *options.stiffness;
  return applyScaleAndCells(options.scale, options.cell_size, inputs);
}

/// A line that rewrites itself on a terminal, once a solve has lasted a second.
IterationCallback progressLine() {
  if (isatty(STDERR_FILENO) == 0) return {};
  const auto start = std::chrono::steady_clock::now();
  return [start](const IterationReport& report) {
    if (std::chrono::steady_clock::now() - start > std::chrono::seconds(1)) {
      std::cerr << fmt::format("\rsolving: iteration {}, gradient {:.1e}   ", report.iteration,
                               report.relative_gradient);
    }
    return NextStep::kContinue;
  };
}

nlohmann::ordered_json numberOrNull(double value) {
  return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
}

nlohmann::ordered_json toJson(const SolvedJob& job, const ProjectorData& projector) {
  const Solution& solution = job.solution;
  nlohmann::ordered_json anchors = nlohmann::ordered_json::array();
  for (const AnchorFit& fit : solution.anchors) {
    anchors.push_back({{"id", fit.id},
                       {"used", fit.used},
                       {"residual_m", numberOrNull(fit.residual_m)},
                       {"leave_one_out_m", numberOrNull(fit.leave_one_out_m)},
                       {"loss_weight", fit.loss_weight}});
  }
  return {{"nodes", job.mesh->nodeCount()},
          {"edges", job.mesh->edges().size()},
          {"components", job.mesh->componentCount()},
          {"cell_size_m", job.mesh->lattice().cell_size},
          {"anchors_used", solution.anchors_used},
          {"model", projector.info.model},
          {"stiffness", nameOf(solution.settings.stiffness)},
          {"plate_share", solution.plate_share},
          {"similarity_share", solution.similarity_share},
          {"scale", solution.global_fit.scale},
          {"rotation_rad", wrapAngle(solution.global_fit.heading)},
          {"cost", solution.cost},
          {"iterations", solution.iterations},
          {"converged", solution.converged},
          {"relative_gradient", solution.relative_gradient},
          {"folded_tiles", projector.info.quality.folded_tiles},
          {"residual_rms_m", projector.info.quality.anchor_rms_m},
          {"leave_one_out_mean_m", projector.info.quality.leave_one_out_mean_m},
          {"seconds",
           {{"load", job.seconds.load},
            {"mesh", job.seconds.mesh},
            {"solve", job.seconds.solve},
            {"write", job.seconds.write}}},
          {"anchors", anchors},
          {"warnings", job.warnings}};
}

void printReport(const SolvedJob& job, const ProjectorData& projector, const std::string& output) {
  const Solution& solution = job.solution;
  const QualityInfo& quality = projector.info.quality;
  fmt::print("{} nodes, {} edges, cells of {:.3g} m; {} of {} anchors used\n", job.mesh->nodeCount(),
             job.mesh->edges().size(), job.mesh->lattice().cell_size, solution.anchors_used, solution.anchors.size());
  fmt::print("{} model{}, scale {:.4f}, rotation {:.2f} deg; {} iterations in {:.3f} s\n", projector.info.model,
             solution.settings.model == Model::kStretch ? " (" + nameOf(solution) + ")" : std::string(),
             solution.global_fit.scale, wrapAngle(solution.global_fit.heading) * 180.0 / kPi, solution.iterations,
             job.seconds.solve);
  fmt::print("residual at the anchors: rms {:.3f} m, max {:.3f} m\n", quality.anchor_rms_m, quality.anchor_max_m);
  if (quality.leave_one_out_max_m > 0.0) {
    fmt::print("without the anchor itself: mean {:.3f} m, median {:.3f} m, max {:.3f} m\n",
               quality.leave_one_out_mean_m, quality.leave_one_out_median_m, quality.leave_one_out_max_m);
    std::vector<AnchorFit> worst = solution.anchors;
    std::sort(worst.begin(), worst.end(), [](const AnchorFit& a, const AnchorFit& b) {
      return (std::isfinite(a.leave_one_out_m) ? a.leave_one_out_m : -1.0) >
             (std::isfinite(b.leave_one_out_m) ? b.leave_one_out_m : -1.0);
    });
    fmt::print("worst anchors:");
    for (std::size_t k = 0; k < std::min<std::size_t>(3, worst.size()); ++k) {
      fmt::print("{} {} ({:.3f} m)", k == 0 ? "" : ",", worst[k].id, worst[k].leave_one_out_m);
    }
    fmt::print("\n");
  }
  fmt::print("written: {}\n", output);
}

Result<void> solveAndWrite(const SolveOptions& options) {
  Result<SolveInputs> inputs = options.project.empty()
                                   ? inputsFromFiles(options.blueprint, options.slam, options.anchors)
                                   : inputsFromProject(options.project, options.map);
  if (!inputs) return failAs(inputs);
  if (Result<void> applied = applyOverrides(options, *inputs); !applied) return applied;
  Result<SolvedJob> job = runSolve(*inputs, options.backend, progressLine());
  if (isatty(STDERR_FILENO) != 0) std::cerr << "\r\033[K";
  if (!job) return failAs(job);

  const auto start = std::chrono::steady_clock::now();
  ProjectorOptions projector_options;
  projector_options.weights = options.weights;
  projector_options.radius_m = options.radius_m;
  projector_options.outside = options.outside;
  projector_options.blueprint = job->blueprint;
  projector_options.slam = job->slam;
  projector_options.creator = std::string("cad2slam-cli ") + kVersion;
  projector_options.created = options.reproducible ? std::string() : creationTime();
  projector_options.project = inputs->project;
  const Result<ProjectorData> projector =
      makeProjectorData(*job->mesh, job->solution, inputs->anchors, projector_options);
  if (!projector) return failAs(projector);
  if (projector->info.quality.folded_tiles > 0) {
    job->warnings.push_back("The mesh folds on " + std::to_string(projector->info.quality.folded_tiles) +
                            " tiles; poses there have no answer. Look at the anchors with the largest errors.");
  }
  if (Result<void> written = writeProjectorFile(options.output, *projector); !written) return written;
  job->seconds.write = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();

  if (options.json) {
    std::cout << toJson(*job, *projector).dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << '\n';
    return {};
  }
  for (const std::string& warning : job->warnings) std::cerr << "cad2slam-cli: warning: " << warning << '\n';
  printReport(*job, *projector, options.output);
  std::fflush(stdout);
  return {};
}

}  // namespace

void addSolveCommand(CLI::App& app, ActionSlot& chosen) {
  auto options = std::make_shared<SolveOptions>();
  CLI::App* command = app.add_subcommand("solve", "Fit the mesh to anchors and write a projector file");
  CLI::Option* project = command->add_option("project", options->project, "Project file (.c2sproj)");
  command->add_option("--map", options->map, "Which SLAM map of the project")->needs(project);
  CLI::Option* blueprint = command->add_option("--blueprint", options->blueprint, "Blueprint (map_server YAML)");
  CLI::Option* slam = command->add_option("--slam", options->slam, "SLAM map (map_server YAML)");
  CLI::Option* anchors =
      command->add_option("--anchors", options->anchors, "Anchors (CSV, or .data of the paper's authors)");
  blueprint->needs(slam)->needs(anchors)->excludes(project);
  slam->needs(blueprint)->excludes(project);
  anchors->needs(blueprint)->excludes(project);
  command->add_option("--model", options->model, "stretch (default) or rigid, the paper's")
      ->check(CLI::IsMember({"stretch", "rigid"}));
  addChoice(*command, "--stiffness", options->stiffness, kStiffnesses,
            "Of the stretch model: auto (default), local (each corridor for itself), smooth (halls that bend) or loose "
            "(noisy clicks)");
  command->add_option(
      "--scale", options->scale,
      "auto: the plan claims to be to scale; unknown: least squares; or SLAM metres per blueprint metre");
  command->add_option("--cell-size", options->cell_size, "Edge length of a mesh cell in metres, or auto");
  addChoice<BlendWeights>(*command, "--weights", options->weights,
                          {{"smooth", BlendWeights::kSmooth}, {"paper", BlendWeights::kPaper}},
                          "How nodes are blended: smooth (default) or paper");
  command->add_option("--radius", options->radius_m, "Radius of the paper's weights in metres")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  addChoice<OutsidePolicy>(*command, "--outside", options->outside,
                           {{"error", OutsidePolicy::kError}, {"rigid", OutsidePolicy::kRigid}},
                           "What the projector answers beyond the mesh: error (default) or rigid");
  addSemantics(*command, options->semantics);
  addChoice<SolverBackend>(*command, "--backend", options->backend,
                           {{"direct", SolverBackend::kDirect}, {"ceres", SolverBackend::kCeres}},
                           "Minimiser: direct (default) or ceres, the slower reference");
  command->add_option("-o,--output", options->output, "Projector file to write (.c2s)")->required();
  command->add_flag("--json", options->json, "Print the report as one JSON object");
  command->add_flag("--reproducible", options->reproducible, "Leave the time out of the file");
  command->callback([options, &chosen] {
    if (options->project.empty() && options->blueprint.empty()) {
      throw CLI::RequiredError("solve: a project, or --blueprint, --slam and --anchors,");
    }
    chosen.set([options] { return solveAndWrite(*options); });
  });
}

}  // namespace cad2slam::cli
