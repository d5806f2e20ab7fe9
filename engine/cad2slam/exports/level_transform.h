// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "cad2slam/geometry/similarity2.h"
#include "cad2slam/geometry/similarity_fit.h"

namespace cad2slam {

/// One similarity for a whole level, as fleet adapters of Open-RMF have it, and what it costs.
struct LevelTransform {
  Similarity2 slam_from_blueprint;
  std::vector<PointPair> references;  ///< blueprint and SLAM [m]; fitting them gives about the same similarity
  std::size_t places = 0;             ///< at which the residuals were measured
  double rms_m = 0.0;
  double max_m = 0.0;
  Eigen::Vector2d worst_in_blueprint = Eigen::Vector2d::Zero();  ///< [m]
  std::string worst_name;                                        ///< of the feature there, or empty
};

}  // namespace cad2slam
