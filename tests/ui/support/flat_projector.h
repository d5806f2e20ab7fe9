// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cad2slam/geometry/similarity2.h"
#include "cad2slam/projection/projector.h"
#include "cad2slam/projection/projector_data.h"

namespace cad2slam::test {

/// A projector over columns x rows tiles from the origin upwards that is exactly one similarity.
inline Projector flatProjector(int columns, int rows, double cell_size, const Similarity2& slam_from_blueprint) {
  ProjectorData data;
  data.info.model = "rigid";
  data.info.scale = slam_from_blueprint.scale;
  data.info.lattice.cell_size = cell_size;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const Eigen::Vector2d center((column + 0.5) * cell_size, (row + 0.5) * cell_size);
      data.node_tile.push_back({column, row});
      data.node_blueprint.push_back(center);
      data.node_slam.push_back(slam_from_blueprint * Pose2{center, 0.0});
      data.node_stretch.push_back(Eigen::Vector2d::Zero());
    }
  }
  return *Projector::create(data);
}

}  // namespace cad2slam::test
