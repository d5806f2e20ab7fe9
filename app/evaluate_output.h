// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

#include "app/evaluate_site.h"
#include "cad2slam/evaluation/anchor_errors.h"
#include "cad2slam/evaluation/scan_comparison.h"
#include "cad2slam/evaluation/speed_benchmark.h"

namespace cad2slam::cli {

using Json = nlohmann::ordered_json;

/// null where the number is not finite.
[[nodiscard]] Json jsonNumber(double value);
[[nodiscard]] Json toJson(const ErrorStatistics& statistics);
[[nodiscard]] Json toJson(const std::vector<MethodErrors>& methods);
/// What was evaluated: files, anchors, nodes.
[[nodiscard]] Json siteJson(const EvaluationSite& site);

/// A table as text, as CSV and as JSON comes from the same rows.
struct TextTable {
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;

  [[nodiscard]] std::string aligned() const;  ///< for a terminal: first column left, the others right
  [[nodiscard]] std::string csv() const;
};

/// One row for each method.
[[nodiscard]] TextTable methodTable(const std::vector<MethodErrors>& methods);
/// The same with a column for a group of rows, e.g. the number of anchors.
void appendMethodRows(TextTable& table, const std::string& group, const std::vector<MethodErrors>& methods);

[[nodiscard]] Json scansJson(const ScanComparison& comparison);
[[nodiscard]] TextTable scanTable(const ScanComparison& comparison);
[[nodiscard]] Json speedJson(const SpeedReport& report);
[[nodiscard]] TextTable speedTable(const SpeedReport& report);

/// Prints JSON or table to stdout, warnings to stderr, and writes the CSV where wanted.
[[nodiscard]] Result<void> emitReport(const EvaluateOptions& options, const std::vector<std::string>& warnings,
                                      const Json& json, const std::string& heading, const TextTable& table);

}  // namespace cad2slam::cli
