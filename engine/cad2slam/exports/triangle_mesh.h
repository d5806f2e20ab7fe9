// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "cad2slam/geometry/similarity_fit.h"

namespace cad2slam {

/// A piecewise linear function of the plane.
struct TriangleMesh {
  std::vector<PointPair> vertices;  ///< blueprint and SLAM frame [m]
  std::vector<std::array<std::uint32_t, 3>> triangles;
  double edge_m = 0.0;           ///< of a block, in the blueprint
  double max_deviation_m = 0.0;  ///< from the projector, in the SLAM frame
};

}  // namespace cad2slam
