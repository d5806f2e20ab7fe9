// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <memory>
#include <string>
#include <vector>

#include "app/evaluate_commands.h"
#include "app/evaluate_output.h"
#include "cad2slam/evaluation/alignment_method.h"
#include "cad2slam/evaluation/scan_comparison.h"
#include "cad2slam/io/paths_csv.h"

namespace cad2slam::cli {
namespace {

struct ScansCommandOptions {
  std::string paths;
  int random_paths = 5;
  std::string model = "stretch";
  double range_m = LidarModel{}.range_max_m;
  int beams = LidarModel{}.beams;
  double step_m = 0.1;
  bool stops_at_unknown = false;
};

Result<void> compare(const EvaluateOptions& options, const ScansCommandOptions& scans) {
  const Result<EvaluationSite> site = loadSite(options);
  if (!site) return failAs(site);
  const Result<OccupancyGrid> slam = loadSlamGrid(*site);
  if (!slam) return failAs(slam);
  ScanOptions scan_options;
  scan_options.lidar.range_max_m = scans.range_m;
  scan_options.lidar.beams = scans.beams;
  scan_options.lidar.stops_at_unknown = scans.stops_at_unknown;
  scan_options.planner.step_m = scans.step_m;
  scan_options.threads = options.threads;
  scan_options.on_progress = progressBar("scans");
  const Result<std::vector<StartGoal>> ends =
      scans.paths.empty() ? randomStartGoals(site->blueprint, scans.random_paths, scan_options.planner, options.seed)
                          : readPathsCsv(scans.paths);
  if (!ends) return failAs(ends);
  MethodFitter fitter(site->mesh, site->inputs.settings);
  const Result<Projector> projector = fitter.fitProjector(
      scans.model == "rigid" ? AlignmentMethod::kRigid : AlignmentMethod::kStretch, site->inputs.anchors);
  if (!projector) return failAs(projector);
  const Result<ScanComparison> result = compareScans(*projector, site->blueprint, *slam, *ends, scan_options);
  if (!result) return failAs(result);

  Json json = siteJson(*site);
  json["model"] = scans.model;
  json["beams"] = scans.beams;
  json["range_m"] = scans.range_m;
  json.update(scansJson(*result));
  return emitReport(options, site->warnings, json,
                    fmt::format("{} paths, {} scans of {} beams ({:.1f} of them meet nothing in the blueprint)",
                                result->paths.size(), result->scans, scans.beams, result->beams_without_hit),
                    scanTable(*result));
}

}  // namespace

void addEvaluateScansCommand(CLI::App& evaluate, const std::shared_ptr<EvaluateOptions>& options, ActionSlot& chosen) {
  auto scans = std::make_shared<ScansCommandOptions>();
  CLI::App* command = evaluate.add_subcommand("scans", "Compare LiDAR scans simulated along paths in both maps");
  addSiteOptions(*command, options);
  command->add_option("--paths", scans->paths, "CSV start_x,start_y,goal_x,goal_y on the blueprint");
  command->add_option("--random-paths", scans->random_paths, "How many random paths without --paths")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  command->add_option("--model", scans->model, "stretch (default) or rigid, the paper's")
      ->check(CLI::IsMember({"stretch", "rigid"}));
  command->add_option("--range", scans->range_m, "Range of the LiDAR in metres of the SLAM map")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command->add_option("--beams", scans->beams, "Beams of one scan, all around")
      ->check(CLI::Range(1, 100'000))
      ->capture_default_str();
  command->add_option("--step", scans->step_m, "Metres of the blueprint between scans")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command->add_flag("--stop-at-unknown", scans->stops_at_unknown, "Beams also end where the maps are unknown");
  command->callback([options, scans, &chosen] {
    requireSite(*options);
    chosen.set([options, scans] { return compare(*options, *scans); });
  });
}

}  // namespace cad2slam::cli
