// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <map>
#include <memory>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "app/evaluate_commands.h"
#include "app/evaluate_output.h"
#include "cad2slam/evaluation/html_report.h"
#include "cad2slam/evaluation/line_chart.h"
#include "cad2slam/evaluation/report_pictures.h"
#include "cad2slam/evaluation/scan_comparison.h"
#include "cad2slam/evaluation/speed_benchmark.h"
#include "cad2slam/evaluation/truth_error.h"
#include "cad2slam/io/atomic_file.h"
#include "cad2slam/io/paths_csv.h"
#include "cad2slam/io/true_warp_file.h"
#include "cad2slam/projection/overlay_picture.h"

namespace cad2slam::cli {
namespace {

constexpr double kMapSpacing = 0.25;  // between the places of an error map [m]

struct AllCommandOptions {
  std::string output;
  std::string paths;
  std::string truth;
  int draws = 10;
};

/// One run of `evaluate all`: the parts write into one page and one JSON object.
class FullEvaluation {
 public:
  FullEvaluation(const EvaluateOptions& options, const AllCommandOptions& command, const EvaluationSite& site,
                 const OccupancyGrid& slam)
      : options_(options),
        command_(command),
        site_(site),
        slam_(slam),
        report_("How good is this projection",
                fmt::format("{} on {}, {} nodes", site.inputs.slam_name,
                            site.inputs.blueprint.image.filename().string(), site.mesh->nodeCount())),
        json_(siteJson(site)) {}

  Result<void> run() {
    for (const std::string& warning : site_.warnings) report_.addParagraph("Note: " + warning);
    if (Result<void> done = overlay(); !done) return done;
    if (Result<void> done = leaveOneOut(); !done) return done;
    if (Result<void> done = curve(); !done) return done;
    if (!command_.truth.empty()) {
      if (Result<void> done = truth(); !done) return done;
    }
    if (Result<void> done = scans(); !done) return done;
    return speed();
  }

  [[nodiscard]] const HtmlReport& report() const { return report_; }
  [[nodiscard]] const Json& json() const { return json_; }

 private:
  [[nodiscard]] EvaluationOptions evaluation(const std::string& what) const {
    return evaluationOptions(options_, site_, what);
  }

  void addTable(const TextTable& table, int group_column = -1) {
    report_.addTable(table.header, table.rows, true, group_column);
  }

  Result<void> addPicture(const Result<cv::Mat>& picture, const std::string& caption) {
    if (!picture) return failAs(picture);
    return report_.addPicture(*picture, caption);
  }

  Result<void> overlay() {
    MeshSolver solver(site_.mesh);
    const Result<Solution> solution = solver.solve(site_.inputs.anchors, site_.inputs.settings);
    if (!solution) return failAs(solution);
    MethodFitter fitter(site_.mesh, site_.inputs.settings);
    Result<Projector> projector = fitter.fitProjector(AlignmentMethod::kStretch, site_.inputs.anchors);
    if (!projector) return failAs(projector);
    projector_ = std::make_unique<Projector>(std::move(*projector));

    report_.addHeading("The alignment");
    report_.addParagraph(fmt::format("Scale {:.4f}, rotation {:.2f} degrees, {} anchors. {} of {} cells are folded.",
                                     solution->global_fit.scale, wrapAngle(solution->global_fit.heading) * 180.0 / kPi,
                                     solution->anchors_used, projector_->foldedTileCount(), site_.mesh->nodeCount()));
    if (solution->similarity_share > 0.0) {
      report_.addParagraph(fmt::format(
          "The anchors hardly tell a bend from the noise of clicks, so {:.0f} % of the answer is the similarity.",
          100.0 * solution->similarity_share));
    }
    for (const std::string& warning : solution->warnings) report_.addParagraph("Note: " + warning);
    std::vector<OverlayAnchor> anchors;
    for (const Anchor& anchor : site_.inputs.anchors) {
      if (anchor.enabled) anchors.push_back({anchor.in_blueprint, anchor.in_slam});
    }
    if (Result<void> added = addPicture(drawOverlay(*projector_, site_.blueprint, slam_, anchors, 1400),
                                        "The warped blueprint (magenta) over the SLAM map (green), dark where they "
                                        "agree; circles are anchors.");
        !added) {
      return added;
    }
    std::vector<PlacedValue> sigmas;
    const std::vector<double> sigma = solver.projectionSigma(site_.mesh->centers());
    for (std::size_t i = 0; i < sigma.size(); ++i) {
      if (std::isfinite(sigma[i])) sigmas.push_back({site_.mesh->centers()[i], sigma[i]});
    }
    if (sigmas.empty()) return {};
    return addPicture(drawValueMap(site_.blueprint, sigmas, site_.mesh->lattice().cell_size, "m"),
                      "Expected error (one standard deviation) as the solver sees it: where it is bright, an anchor is "
                      "missing.");
  }

  Result<void> leaveOneOut() {
    const Result<LeaveOneOut> result =
        evaluateLeaveOneOut(site_.mesh, site_.inputs.anchors, evaluation("leave-one-out"));
    if (!result) return failAs(result);
    json_["loo"] = {{"methods", toJson(result->methods)}};
    report_.addHeading("Leave-one-out");
    report_.addParagraph("How far each anchor is missed when everything is solved again without it. Bold is best.");
    addTable(methodTable(result->methods));
    report_.addParagraph(verdict(result->methods));
    return {};
  }

  /// Whether the mesh is worth its trouble here, in words.
  static std::string verdict(const std::vector<MethodErrors>& methods) {
    constexpr double kWorthIt = 1.1;
    std::map<AlignmentMethod, double> means;
    for (const MethodErrors& method : methods) means[method.method] = method.statistics.mean;
    const double similarity = means[AlignmentMethod::kSimilarity];
    const double stretch = means[AlignmentMethod::kStretch];
    if (similarity > kWorthIt * stretch) {
      return fmt::format("The mesh pays off: a plain similarity would miss by {:.2f} m instead of {:.2f} m.",
                         similarity, stretch);
    }
    return fmt::format(
        "Nothing non-rigid helps here: a plain similarity is as good ({:.2f} m against {:.2f} m). Either this map is "
        "hardly bent, or there are too few anchors to tell how.",
        similarity, stretch);
  }

  Result<void> curve() {
    CurveOptions curve_options;
    curve_options.draws = command_.draws;
    curve_options.seed = options_.seed;
    const Result<LearningCurve> result =
        evaluateLearningCurve(site_.mesh, site_.inputs.anchors, curve_options, evaluation("learning curve"));
    if (!result) return failAs(result);
    Json sizes = Json::object();
    TextTable table{{"error in m", "anchors", "mean", "median", "p90", "p95", "max"}, {}};
    std::map<AlignmentMethod, ChartSeries> lines;
    for (const LearningCurve::Point& point : result->points) {
      sizes[std::to_string(point.size)] = {{"methods", toJson(point.methods)}};
      appendMethodRows(table, std::to_string(point.size), point.methods);
      for (const MethodErrors& method : point.methods) {
        lines[method.method].points.emplace_back(point.size, method.statistics.mean);
      }
    }
    json_["curve"] = {{"draws", command_.draws}, {"seed", options_.seed}, {"sizes", std::move(sizes)}};
    report_.addHeading("How many anchors are needed");
    if (result->points.empty()) {
      report_.addParagraph("There are too few anchors for a learning curve.");
      return {};
    }
    report_.addParagraph(fmt::format(
        "Mean error at the anchors that were not used, over {} random choices of the used ones.", command_.draws));
    std::vector<ChartSeries> series;
    for (auto& [method, line] : lines) {
      line.label = methodLabel(method);
      line.color = color(method);
      line.emphasised = method == AlignmentMethod::kStretch;
      series.push_back(line);
    }
    report_.addSvg(drawLineChart(series, "anchors used", "mean error in m"), "Both axes are logarithmic.");
    addTable(table, 1);
    return {};
  }

  /// Okabe and Ito's colours, which people with colour-blindness can tell apart.
  static std::string color(AlignmentMethod method) {
    switch (method) {
      case AlignmentMethod::kSimilarity:
        return "#999999";
      case AlignmentMethod::kAffine:
        return "#cc79a7";
      case AlignmentMethod::kThinPlateSpline:
        return "#e69f00";
      case AlignmentMethod::kRigid:
        return "#d55e00";
      case AlignmentMethod::kRigidScaled:
        return "#56b4e9";
      case AlignmentMethod::kStretch:
        return "#009e73";
    }
    return "#000000";
  }

  Result<void> truth() {
    const Result<TrueWarp> warp = readTrueWarp(command_.truth);
    if (!warp) return failAs(warp);
    const Result<TruthErrors> result =
        evaluateTruth(site_.mesh, site_.inputs.anchors, site_.blueprint, *warp, evaluation("truth"), kMapSpacing);
    if (!result) return failAs(result);
    json_["truth"] = {{"places", result->places.size()},
                      {"outside_mesh", result->outside},
                      {"methods", toJson(result->methods)},
                      {"heading_rad", toJson(result->heading_rad)}};
    report_.addHeading("True error");
    report_.addParagraph(
        fmt::format("At {} places of the free space; the true warp of this site is known. Mean error "
                    "of the stretch model's headings: {:.2f} degrees.",
                    result->places.size(), result->heading_rad.mean * 180.0 / kPi));
    addTable(methodTable(result->methods));
    for (const MethodErrors& method : result->methods) {
      if (method.method != AlignmentMethod::kStretch) continue;
      std::vector<PlacedValue> values;
      for (std::size_t i = 0; i < result->places.size(); ++i) {
        values.push_back({result->places[i].in_blueprint, method.errors_m[i]});
      }
      return addPicture(drawValueMap(site_.blueprint, values, kMapSpacing, "m"), "True error of the stretch model.");
    }
    return {};
  }

  Result<void> scans() {
    ScanOptions scan_options;
    scan_options.threads = options_.threads;
    scan_options.on_progress = progressBar("scans");
    const Result<std::vector<StartGoal>> ends =
        command_.paths.empty() ? randomStartGoals(site_.blueprint, 5, scan_options.planner, options_.seed)
                               : readPathsCsv(command_.paths);
    if (!ends) return failAs(ends);
    const Result<ScanComparison> result = compareScans(*projector_, site_.blueprint, slam_, *ends, scan_options);
    if (!result) return failAs(result);
    json_["scans"] = scansJson(*result);
    report_.addHeading("Scans along paths");
    report_.addParagraph(fmt::format(
        "{} paths are planned on the blueprint and projected. At {} places a LiDAR of {} beams is simulated in both "
        "maps; the blueprint's hits are projected and compared with the nearest hit in the SLAM map. A hit without a "
        "counterpart within the threshold is an outlier; {:.1f} beams of a scan meet nothing in the blueprint and make "
        "no hit. What stands in one map only (furniture, niches) makes outliers however good the projection is.",
        result->paths.size(), result->scans, scan_options.lidar.beams, result->beams_without_hit));
    report_.addTable({"threshold m", "mean m", "deviation m", "outliers"}, scanTable(*result).rows);
    std::vector<std::vector<PlacedValue>> on_blueprint;
    std::vector<std::vector<PlacedValue>> on_slam;
    for (const ComparedPath& path : result->paths) {
      std::vector<PlacedValue> blueprint_way;
      std::vector<PlacedValue> slam_way;
      for (std::size_t i = 0; i < path.in_slam.size(); ++i) {
        blueprint_way.push_back({path.in_blueprint.poses[i].translation, path.median_distance_m[i]});
        slam_way.push_back({path.in_slam[i].translation, path.median_distance_m[i]});
      }
      on_blueprint.push_back(std::move(blueprint_way));
      on_slam.push_back(std::move(slam_way));
    }
    if (Result<void> added =
            addPicture(drawWays(site_.blueprint, on_blueprint, "m"),
                       "The paths on the blueprint, coloured by the median distance between the scans there.");
        !added) {
      return added;
    }
    return addPicture(drawWays(slam_, on_slam, "m"), "The same paths, projected into the SLAM map.");
  }

  Result<void> speed() {
    SpeedOptions speed_options;
    speed_options.settings = site_.inputs.settings;
    speed_options.cell_size_m = site_.inputs.cell_size_m;
    speed_options.repetitions = 3;
    speed_options.threads = options_.threads;
    const Result<SpeedReport> result = measureSpeed(site_.blueprint, site_.inputs.anchors, speed_options);
    if (!result) return failAs(result);
    json_["speed"] = speedJson(*result);
    report_.addHeading("Speed");
    report_.addParagraph("On the machine that made this page, while it made it.");
    const TextTable table = speedTable(*result);
    report_.addTable(table.header, table.rows);
    return {};
  }

  const EvaluateOptions& options_;
  const AllCommandOptions& command_;
  const EvaluationSite& site_;
  const OccupancyGrid& slam_;
  HtmlReport report_;
  Json json_;
  std::unique_ptr<Projector> projector_;
};

Result<void> evaluateAll(const EvaluateOptions& options, const AllCommandOptions& command) {
  const auto start = std::chrono::steady_clock::now();
  const Result<EvaluationSite> site = loadSite(options);
  if (!site) return failAs(site);
  const Result<OccupancyGrid> slam = loadSlamGrid(*site);
  if (!slam) return failAs(slam);
  FullEvaluation evaluation(options, command, *site, *slam);
  if (Result<void> done = evaluation.run(); !done) return done;

  const std::filesystem::path folder = command.output;
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) return fail(ErrorCode::kUnwritable, "the folder cannot be made: " + error.message(), folder.string());
  if (Result<void> written = writeFileAtomically(folder / "report.html", evaluation.report().page()); !written) {
    return written;
  }
  const std::string text = evaluation.json().dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
  if (Result<void> written = writeFileAtomically(folder / "report.json", text); !written) return written;
  if (options.json) {
    std::cout << text;
  } else {
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    std::cout << fmt::format("written: {} and report.json, in {:.0f} s\n", (folder / "report.html").string(),
                             took.count());
  }
  return {};
}

}  // namespace

void addEvaluateAllCommand(CLI::App& evaluate, const std::shared_ptr<EvaluateOptions>& options, ActionSlot& chosen) {
  auto all = std::make_shared<AllCommandOptions>();
  CLI::App* command = evaluate.add_subcommand("all", "Everything on one self-contained HTML page");
  addSiteOptions(*command, options);
  command->add_option("-o,--output", all->output, "Folder for report.html and report.json")->required();
  command->add_option("--paths", all->paths, "CSV start_x,start_y,goal_x,goal_y on the blueprint (default: random)");
  command->add_option("--truth", all->truth, "True warp (YAML) of a site where it is known");
  command->add_option("--draws", all->draws, "Random draws of each size of the learning curve")
      ->check(CLI::Range(1, 10'000))
      ->capture_default_str();
  command->callback([options, all, &chosen] {
    requireSite(*options);
    chosen.set([options, all] { return evaluateAll(*options, *all); });
  });
}

}  // namespace cad2slam::cli
