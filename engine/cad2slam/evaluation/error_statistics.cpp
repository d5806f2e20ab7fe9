// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/evaluation/error_statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cad2slam {
namespace {

double quantile(const std::vector<double>& sorted, double part) {
  const double rank = part * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(rank);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  const double weight = rank - static_cast<double>(below);
  return weight == 0.0 ? sorted[below] : (1.0 - weight) * sorted[below] + weight * sorted[above];
}

}  // namespace

ErrorStatistics summarise(std::vector<double> errors) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  if (errors.empty()) return {0, kNaN, kNaN, kNaN, kNaN, kNaN, kNaN};
  for (double& error : errors) {
    if (!std::isfinite(error)) error = std::numeric_limits<double>::infinity();
  }
  std::sort(errors.begin(), errors.end());
  const auto count = static_cast<double>(errors.size());
  double sum = 0.0;
  for (const double error : errors) sum += error;
  ErrorStatistics statistics{};
  statistics.count = errors.size();
  statistics.mean = sum / count;
  double squares = 0.0;
  for (const double error : errors) squares += (error - statistics.mean) * (error - statistics.mean);
  statistics.deviation = std::sqrt(squares / count);
  statistics.median = quantile(errors, 0.5);
  statistics.p90 = quantile(errors, 0.9);
  statistics.p95 = quantile(errors, 0.95);
  statistics.max = errors.back();
  return statistics;
}

}  // namespace cad2slam
