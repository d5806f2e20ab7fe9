// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <memory>

#include "app/evaluate_commands.h"
#include "app/evaluate_output.h"
#include "cad2slam/evaluation/speed_benchmark.h"

namespace cad2slam::cli {
namespace {

struct SpeedCommandOptions {
  std::string model = "stretch";
  int repetitions = SpeedOptions{}.repetitions;
};

Result<void> measure(const EvaluateOptions& options, const SpeedCommandOptions& command) {
  const Result<EvaluationSite> site = loadSite(options);
  if (!site) return failAs(site);
  SpeedOptions speed;
  speed.settings = command.model == "rigid" ? defaultSettings(Model::kRigid) : site->inputs.settings;
  speed.cell_size_m = site->inputs.cell_size_m;
  speed.repetitions = command.repetitions;
  speed.threads = options.threads;
  speed.seed = options.seed;
  const Result<SpeedReport> report = measureSpeed(site->blueprint, site->inputs.anchors, speed);
  if (!report) return failAs(report);

  Json json = siteJson(*site);
  json["model"] = command.model;
  json["load_ms"] = 1e3 * site->load_seconds;
  json.update(speedJson(*report));
  return emitReport(options, site->warnings, json,
                    fmt::format("{} nodes, {} edges, {} anchors, {} model", report->nodes, report->edges,
                                report->anchors, command.model),
                    speedTable(*report));
}

}  // namespace

void addEvaluateSpeedCommand(CLI::App& evaluate, const std::shared_ptr<EvaluateOptions>& options, ActionSlot& chosen) {
  auto speed = std::make_shared<SpeedCommandOptions>();
  CLI::App* command = evaluate.add_subcommand("speed", "Times of construction, optimisation and projection");
  addSiteOptions(*command, options);
  command->add_option("--model", speed->model, "stretch (default) or rigid, the paper's")
      ->check(CLI::IsMember({"stretch", "rigid"}));
  command->add_option("--repetitions", speed->repetitions, "Of construction and optimisation")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  command->callback([options, speed, &chosen] {
    requireSite(*options);
    chosen.set([options, speed] { return measure(*options, *speed); });
  });
}

}  // namespace cad2slam::cli
