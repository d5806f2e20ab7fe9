// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

namespace cad2slam {

/// A sample of errors in a few numbers; NaN when the sample is empty.
struct ErrorStatistics {
  std::size_t count = 0;
  double mean;
  double deviation;  ///< of the population, not of the mean
  double median;
  double p90;
  double p95;
  double max;
};

/// Quantiles are interpolated between neighbours in rank. Errors that are not finite count as infinite.
[[nodiscard]] ErrorStatistics summarise(std::vector<double> errors);

}  // namespace cad2slam
