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

/// Mean of numbers that are not negative, each capped at four times their median: a wrong anchor must not decide which
/// of two fits is better. Infinite for no number.
[[nodiscard]] inline double cappedMean(std::vector<double> numbers) {
  if (numbers.empty()) return std::numeric_limits<double>::infinity();
  const auto middle = numbers.begin() + static_cast<std::ptrdiff_t>(numbers.size() / 2);
  std::nth_element(numbers.begin(), middle, numbers.end());
  const double cap = 4.0 * *middle;
  double sum = 0.0;
  for (const double number : numbers) sum += std::min(number, cap);
  return sum / static_cast<double>(numbers.size());
}

}  // namespace cad2slam
