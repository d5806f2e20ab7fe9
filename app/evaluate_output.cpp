// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "app/evaluate_output.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>

#include "cad2slam/io/atomic_file.h"

namespace cad2slam::cli {
namespace {

std::string metres(double value) {
  return std::isfinite(value) ? fmt::format("{:.3f}", value) : "-";
}

std::vector<std::string> statisticsCells(const ErrorStatistics& statistics) {
  return {metres(statistics.mean), metres(statistics.median), metres(statistics.p90), metres(statistics.p95),
          metres(statistics.max)};
}

std::string csvCell(const std::string& cell) {
  if (cell.find_first_of(",\"\n") == std::string::npos) return cell;
  std::string quoted = "\"";
  for (const char c : cell) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + "\"";
}

Json agreementJson(const std::vector<ScanAgreement>& agreements) {
  Json json = Json::array();
  for (const ScanAgreement& agreement : agreements) {
    json.push_back({{"threshold_m", agreement.threshold_m},
                    {"mean_m", jsonNumber(agreement.mean_m)},
                    {"deviation_m", jsonNumber(agreement.deviation_m)},
                    {"outliers", jsonNumber(agreement.outliers)},
                    {"sum_of_squares_m2", jsonNumber(agreement.sum_of_squares_m2)}});
  }
  return json;
}

Json meanAndDeviation(const ErrorStatistics& statistics) {
  return {{"mean", jsonNumber(statistics.mean)},
          {"deviation", jsonNumber(statistics.deviation)},
          {"median", jsonNumber(statistics.median)},
          {"p95", jsonNumber(statistics.p95)}};
}

}  // namespace

Json jsonNumber(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json toJson(const ErrorStatistics& statistics) {
  return {{"count", statistics.count},
          {"mean", jsonNumber(statistics.mean)},
          {"median", jsonNumber(statistics.median)},
          {"p90", jsonNumber(statistics.p90)},
          {"p95", jsonNumber(statistics.p95)},
          {"max", jsonNumber(statistics.max)}};
}

Json toJson(const std::vector<MethodErrors>& methods) {
  Json json = Json::object();
  for (const MethodErrors& method : methods) json[methodKey(method.method)] = toJson(method.statistics);
  return json;
}

Json siteJson(const EvaluationSite& site) {
  const auto used = std::count_if(site.inputs.anchors.begin(), site.inputs.anchors.end(),
                                  [](const Anchor& anchor) { return anchor.enabled; });
  return {{"blueprint", site.inputs.blueprint.image.filename().string()},
          {"slam", site.inputs.slam.image.filename().string()},
          {"anchors", used},
          {"nodes", site.mesh->nodeCount()},
          {"cell_size_m", site.mesh->lattice().cell_size}};
}

std::string TextTable::aligned() const {
  std::vector<std::size_t> widths(header.size(), 0);
  const auto measure = [&](const std::vector<std::string>& cells) {
    for (std::size_t i = 0; i < cells.size(); ++i) widths[i] = std::max(widths[i], cells[i].size());
  };
  measure(header);
  for (const auto& row : rows) measure(row);
  std::string text;
  const auto append = [&](const std::vector<std::string>& cells) {
    for (std::size_t i = 0; i < cells.size(); ++i) {
      text += i == 0 ? fmt::format("{:<{}}", cells[i], widths[i]) : fmt::format("  {:>{}}", cells[i], widths[i]);
    }
    text += '\n';
  };
  append(header);
  for (const auto& row : rows) append(row);
  return text;
}

std::string TextTable::csv() const {
  std::string text;
  const auto append = [&](const std::vector<std::string>& cells) {
    for (std::size_t i = 0; i < cells.size(); ++i) text += (i == 0 ? "" : ",") + csvCell(cells[i]);
    text += '\n';
  };
  append(header);
  for (const auto& row : rows) append(row);
  return text;
}

TextTable methodTable(const std::vector<MethodErrors>& methods) {
  TextTable table{{"error in m", "mean", "median", "p90", "p95", "max"}, {}};
  for (const MethodErrors& method : methods) {
    std::vector<std::string> row = statisticsCells(method.statistics);
    row.insert(row.begin(), methodLabel(method.method));
    table.rows.push_back(std::move(row));
  }
  return table;
}

void appendMethodRows(TextTable& table, const std::string& group, const std::vector<MethodErrors>& methods) {
  for (const MethodErrors& method : methods) {
    std::vector<std::string> row = statisticsCells(method.statistics);
    row.insert(row.begin(), {methodLabel(method.method), group});
    table.rows.push_back(std::move(row));
  }
}

Json scansJson(const ScanComparison& comparison) {
  Json paths = Json::array();
  for (const ComparedPath& path : comparison.paths) {
    paths.push_back({{"start", {path.ends.start.x(), path.ends.start.y()}},
                     {"goal", {path.ends.goal.x(), path.ends.goal.y()}},
                     {"length_m", path.in_blueprint.length_m},
                     {"scans", path.in_slam.size()},
                     {"thresholds", agreementJson(path.agreement)}});
  }
  return {{"scans", comparison.scans},
          {"beams_without_hit", comparison.beams_without_hit},
          {"thresholds", agreementJson(comparison.agreement)},
          {"paths", std::move(paths)}};
}

TextTable scanTable(const ScanComparison& comparison) {
  TextTable table{{"threshold m", "mean m", "deviation m", "outliers"}, {}};
  for (const ScanAgreement& agreement : comparison.agreement) {
    table.rows.push_back({fmt::format("{:.2f}", agreement.threshold_m), fmt::format("{:.4f}", agreement.mean_m),
                          fmt::format("{:.4f}", agreement.deviation_m), fmt::format("{:.0f}", agreement.outliers)});
  }
  return table;
}

Json speedJson(const SpeedReport& report) {
  Json json = {{"nodes", report.nodes}};
  json["edges"] = report.edges;
  json["construction_ms"] = meanAndDeviation(report.construction_ms);
  json["optimisation_ms"] = meanAndDeviation(report.optimisation_ms);
  json["after_an_edit_ms"] = meanAndDeviation(report.again_ms);
  json["projection_us"] = meanAndDeviation(report.projection_us);
  json["inverse_us"] = meanAndDeviation(report.inverse_us);
  json["batch_projections_per_s"] = report.batch_projections_per_s;
  json["batch_inverses_per_s"] = report.batch_inverses_per_s;
  json["projector_bytes"] = report.projector_bytes;
  json["peak_memory_bytes"] = report.peak_memory_bytes;
  return json;
}

TextTable speedTable(const SpeedReport& report) {
  TextTable table{{"", "mean", "deviation", "median"}, {}};
  const auto add = [&](const std::string& name, const ErrorStatistics& statistics) {
    table.rows.push_back({name, fmt::format("{:.3f}", statistics.mean), fmt::format("{:.3f}", statistics.deviation),
                          fmt::format("{:.3f}", statistics.median)});
  };
  add("mesh construction, ms", report.construction_ms);
  add("optimisation, ms", report.optimisation_ms);
  add("optimisation after an edit, ms", report.again_ms);
  add("projection of a pose, us", report.projection_us);
  add("inverse of a pose, us", report.inverse_us);
  const auto add_number = [&](const std::string& name, double value) {
    table.rows.push_back({name, fmt::format("{:.2f}", value), "", ""});
  };
  add_number("batch projections, M poses/s", 1e-6 * report.batch_projections_per_s);
  add_number("batch inverses, M poses/s", 1e-6 * report.batch_inverses_per_s);
  add_number("projector, MB", 1e-6 * report.projector_bytes);
  add_number("peak memory of the process, MB", 1e-6 * report.peak_memory_bytes);
  return table;
}

Result<void> emitReport(const EvaluateOptions& options, const std::vector<std::string>& warnings, const Json& json,
                        const std::string& heading, const TextTable& table) {
  if (!options.csv.empty()) {
    if (Result<void> written = writeFileAtomically(options.csv, table.csv()); !written) return written;
  }
  for (const std::string& warning : warnings) std::cerr << "cad2slam-cli: warning: " << warning << '\n';
  if (options.json) {
    std::cout << json.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
  } else {
    std::cout << heading << '\n' << table.aligned();
  }
  return {};
}

}  // namespace cad2slam::cli
