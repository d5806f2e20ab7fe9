// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

namespace cad2slam {

/// Anchors may be missed by this much [m] because of clicks and of buildings that are not as drawn. More is a bend of
/// the map, which must not be smoothed away.
inline constexpr double kNoise_m = 0.4;

/// Four times the median of at least one number: residuals above it are those of wrong anchors.
[[nodiscard]] inline double residualCap(std::vector<double> numbers) {
  const auto middle = numbers.begin() + static_cast<std::ptrdiff_t>(numbers.size() / 2);
  std::nth_element(numbers.begin(), middle, numbers.end());
  return 4.0 * *middle;
}

/// Mean of numbers that are not negative, each capped at residualCap(): a wrong anchor must not decide which of two
/// fits is better. Infinite for no number.
[[nodiscard]] inline double cappedMean(const std::vector<double>& numbers) {
  if (numbers.empty()) return std::numeric_limits<double>::infinity();
  const double cap = residualCap(numbers);
  double sum = 0.0;
  for (const double number : numbers) sum += std::min(number, cap);
  return sum / static_cast<double>(numbers.size());
}

}  // namespace cad2slam
