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

Json meanAndDeviation(const ErrorStatistics& statistics) {
  return {{"mean", jsonNumber(statistics.mean)},
          {"deviation", jsonNumber(statistics.deviation)},
          {"median", jsonNumber(statistics.median)},
          {"p95", jsonNumber(statistics.p95)}};
}

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
  json["edges"] = report->edges;
  json["load_ms"] = 1e3 * site->load_seconds;
  json["construction_ms"] = meanAndDeviation(report->construction_ms);
  json["optimisation_ms"] = meanAndDeviation(report->optimisation_ms);
  json["after_an_edit_ms"] = meanAndDeviation(report->again_ms);
  json["projection_us"] = meanAndDeviation(report->projection_us);
  json["inverse_us"] = meanAndDeviation(report->inverse_us);
  json["batch_projections_per_s"] = report->batch_projections_per_s;
  json["batch_inverses_per_s"] = report->batch_inverses_per_s;
  json["projector_bytes"] = report->projector_bytes;
  json["peak_memory_bytes"] = report->peak_memory_bytes;

  TextTable table{{"", "mean", "deviation", "median"}, {}};
  const auto add = [&](const std::string& name, const ErrorStatistics& statistics) {
    table.rows.push_back({name, fmt::format("{:.3f}", statistics.mean), fmt::format("{:.3f}", statistics.deviation),
                          fmt::format("{:.3f}", statistics.median)});
  };
  add("mesh construction, ms", report->construction_ms);
  add("optimisation, ms", report->optimisation_ms);
  add("optimisation after an edit, ms", report->again_ms);
  add("projection of a pose, us", report->projection_us);
  add("inverse of a pose, us", report->inverse_us);
  const auto add_number = [&](const std::string& name, double value) {
    table.rows.push_back({name, fmt::format("{:.2f}", value), "", ""});
  };
  add_number("batch projections, M poses/s", 1e-6 * report->batch_projections_per_s);
  add_number("batch inverses, M poses/s", 1e-6 * report->batch_inverses_per_s);
  add_number("projector, MB", 1e-6 * report->projector_bytes);
  add_number("peak memory of the process, MB", 1e-6 * report->peak_memory_bytes);
  return emitReport(options, site->warnings, json,
                    fmt::format("{} nodes, {} edges, {} anchors, {} model", report->nodes, report->edges,
                                report->anchors, command.model),
                    table);
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
