// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include <string>
#include <vector>

namespace cad2slam {

struct ChartSeries {
  std::string label;
  std::string color;  ///< CSS
  std::vector<Eigen::Vector2d> points;
  bool emphasised = false;
};

/// An SVG with both axes logarithmic and the labels written beside the ends of the lines. Points that are not positive
/// and finite are left out; without any point the chart says so.
[[nodiscard]] std::string drawLineChart(const std::vector<ChartSeries>& series, const std::string& x_label,
                                        const std::string& y_label);

}  // namespace cad2slam
