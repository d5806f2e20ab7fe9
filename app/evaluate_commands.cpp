// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "app/cli_command.h"
#include "app/evaluate_commands.h"
#include "app/evaluate_output.h"
#include "app/evaluate_site.h"
#include "cad2slam/evaluation/site_survey.h"
#include "cad2slam/evaluation/truth_error.h"
#include "cad2slam/io/atomic_file.h"
#include "cad2slam/io/true_warp_file.h"

namespace cad2slam::cli {
namespace {

struct CurveCommandOptions {
  std::vector<int> sizes = CurveOptions{}.sizes;
  int draws = CurveOptions{}.draws;
};

Result<void> leaveOneOut(const EvaluateOptions& options) {
  const Result<EvaluationSite> site = loadSite(options);
  if (!site) return failAs(site);
  const EvaluationOptions evaluation = evaluationOptions(options, *site, "leave-one-out");
  const Result<LeaveOneOut> result = evaluateLeaveOneOut(site->mesh, site->inputs.anchors, evaluation);
  if (!result) return failAs(result);
  Json json = siteJson(*site);
  json["methods"] = toJson(result->methods);
  return emitReport(
      options, site->warnings, json,
      fmt::format("Leave-one-out over {} anchors, {} nodes", result->anchors.size(), site->mesh->nodeCount()),
      methodTable(result->methods));
}

Result<void> learningCurve(const EvaluateOptions& options, const CurveCommandOptions& curve) {
  const Result<EvaluationSite> site = loadSite(options);
  if (!site) return failAs(site);
  const EvaluationOptions evaluation = evaluationOptions(options, *site, "learning curve");
  const Result<LearningCurve> result =
      evaluateLearningCurve(site->mesh, site->inputs.anchors, {curve.sizes, curve.draws, options.seed}, evaluation);
  if (!result) return failAs(result);
  Json json = siteJson(*site);
  json["draws"] = curve.draws;
  json["seed"] = options.seed;
  json["sizes"] = Json::object();
  TextTable table{{"error in m", "anchors", "mean", "median", "p90", "p95", "max"}, {}};
  for (const LearningCurve::Point& point : result->points) {
    json["sizes"][std::to_string(point.size)] = {{"methods", toJson(point.methods)}};
    appendMethodRows(table, std::to_string(point.size), point.methods);
  }
  return emitReport(options, site->warnings, json,
                    fmt::format("Error at anchors that were not used, {} draws, seed {}", curve.draws, options.seed),
                    table);
}

Result<void> againstTruth(const EvaluateOptions& options, const std::string& truth_file) {
  const Result<EvaluationSite> site = loadSite(options);
  if (!site) return failAs(site);
  const Result<TrueWarp> truth = readTrueWarp(truth_file);
  if (!truth) return failAs(truth);
  const Result<TruthErrors> result = evaluateTruth(site->mesh, site->inputs.anchors, site->blueprint, *truth,
                                                   evaluationOptions(options, *site, "truth"));
  if (!result) return failAs(result);
  Json json = siteJson(*site);
  json["places"] = result->places.size();
  json["outside_mesh"] = result->outside;
  json["methods"] = toJson(result->methods);
  json["heading_rad"] = toJson(result->heading_rad);
  return emitReport(options, site->warnings, json,
                    fmt::format("True error at {} places of the free space", result->places.size()),
                    methodTable(result->methods));
}

struct SurveyCommandOptions {
  int sites = SurveyOptions{}.sites;
  int anchors = 0;  ///< 0: each site's own number
};

Result<void> randomSites(const EvaluateOptions& options, const SurveyCommandOptions& survey) {
  EvaluationOptions evaluation;
  evaluation.threads = options.threads;
  evaluation.on_progress = progressBar("sites");
  if (Result<void> applied = applyOverrides(options.overrides, evaluation.stretch); !applied) return applied;
  SurveyOptions survey_options;
  survey_options.sites = survey.sites;
  survey_options.first_seed = options.seed;
  if (survey.anchors > 0) survey_options.anchors = survey.anchors;
  const Result<SiteSurvey> result = surveySites(survey_options, evaluation);
  if (!result) return failAs(result);

  std::vector<AlignmentMethod> others = evaluation.methods;
  others.erase(std::remove(others.begin(), others.end(), AlignmentMethod::kStretch), others.end());
  Json json = {{"sites", result->sites.size()}, {"seed", options.seed}, {"methods", Json::object()}};
  TextTable summary{{"over all sites", "geometric mean m", "/ best of others", "within 5 % of it"}, {}};
  for (const AlignmentMethod method : evaluation.methods) {
    const double ratio = result->ratioToBest(method, others);
    const double share = result->shareWithin(method, others, 1.05);
    json["methods"][methodKey(method)] = {{"geometric_mean_m", jsonNumber(result->geometricMean(method))},
                                          {"ratio_to_best", jsonNumber(ratio)},
                                          {"share_within_5_percent", jsonNumber(share)}};
    summary.rows.push_back({methodLabel(method), fmt::format("{:.4f}", result->geometricMean(method)),
                            fmt::format("{:.3f}", ratio), fmt::format("{:.0f} %", 100.0 * share)});
  }
  TextTable rows{{"seed", "kind", "layout", "size_m", "plan_scale", "anchors"}, {}};
  for (const AlignmentMethod method : evaluation.methods) rows.header.push_back(methodKey(method));
  for (const SurveyedSite& site : result->sites) {
    std::vector<std::string> row = {std::to_string(site.seed),
                                    siteKindName(site.kind),
                                    anchorLayoutName(site.layout),
                                    fmt::format("{:.1f}", site.size_m),
                                    fmt::format("{:.4f}", site.plan_scale),
                                    std::to_string(site.anchors)};
    for (const double error : site.mean_error_m) row.push_back(fmt::format("{:.5f}", error));
    rows.rows.push_back(std::move(row));
  }
  if (!options.csv.empty()) {
    if (Result<void> written = writeFileAtomically(options.csv, rows.csv()); !written) return written;
  }
  EvaluateOptions without_csv = options;  // the CSV holds the sites, not the summary
  without_csv.csv.clear();
  return emitReport(without_csv, {}, json, fmt::format("Mean true error on {} random sites", result->sites.size()),
                    summary);
}

/// A subcommand of `evaluate` with the options of all of them.
CLI::App* addPart(CLI::App& evaluate, const std::shared_ptr<EvaluateOptions>& options, const std::string& name,
                  const std::string& description) {
  CLI::App* command = evaluate.add_subcommand(name, description);
  addSiteOptions(*command, options);
  return command;
}

}  // namespace

void addEvaluateCommand(CLI::App& app, ActionSlot& chosen) {
  CLI::App* evaluate = app.add_subcommand("evaluate", "Measure how good projections are");
  evaluate->require_subcommand(1);
  auto options = std::make_shared<EvaluateOptions>();

  CLI::App* loo = addPart(*evaluate, options, "loo", "Error at each anchor, solved without it");
  loo->callback([options, &chosen] {
    requireSite(*options);
    chosen.set([options] { return leaveOneOut(*options); });
  });

  auto curve_options = std::make_shared<CurveCommandOptions>();
  CLI::App* curve = addPart(*evaluate, options, "curve", "Error at unused anchors against the number of used ones");
  curve->add_option("--sizes", curve_options->sizes, "Numbers of anchors")->delimiter(',')->capture_default_str();
  curve->add_option("--draws", curve_options->draws, "Random draws of each size")->capture_default_str();
  curve->callback([options, curve_options, &chosen] {
    requireSite(*options);
    chosen.set([options, curve_options] { return learningCurve(*options, *curve_options); });
  });

  auto truth_file = std::make_shared<std::string>();
  CLI::App* truth = addPart(*evaluate, options, "truth", "True error all over a site whose warp is known");
  truth->add_option("--truth", *truth_file, "True warp (YAML)")->required();
  truth->callback([options, truth_file, &chosen] {
    requireSite(*options);
    chosen.set([options, truth_file] { return againstTruth(*options, *truth_file); });
  });

  auto survey_options = std::make_shared<SurveyCommandOptions>();
  CLI::App* sites = evaluate->add_subcommand("sites", "True error on random sites that are made on the fly");
  addRunOptions(*sites, options);
  sites->add_option("--count", survey_options->sites, "How many sites")->capture_default_str();
  sites->add_option("--anchors", survey_options->anchors, "Anchors at each site (default: random, 4 to 60)");
  sites->callback([options, survey_options, &chosen] {
    chosen.set([options, survey_options] { return randomSites(*options, *survey_options); });
  });

  addEvaluateScansCommand(*evaluate, options, chosen);
  addEvaluateSpeedCommand(*evaluate, options, chosen);
  addEvaluateAllCommand(*evaluate, options, chosen);
}

}  // namespace cad2slam::cli
