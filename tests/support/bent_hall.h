// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>

#include "cad2slam/projection/projector.h"

namespace cad2slam::test {

/// A hall of 20 x 10 tiles of 1 m that is bent to the left.
inline ProjectorData bentHallData() {
  ProjectorData data;
  for (std::int32_t column = 0; column < 20; ++column) {
    for (std::int32_t row = 0; row < 10; ++row) {
      const double turn = 0.06 * column;
      data.node_tile.push_back({column, row});
      data.node_blueprint.emplace_back(column + 0.5, row + 0.5);
      data.node_slam.push_back({(20.0 - row) * Eigen::Vector2d(std::sin(turn), -std::cos(turn)), turn});
      data.node_stretch.emplace_back(0.0, 0.0);
    }
  }
  return data;
}

inline Projector bentHall() {
  return *Projector::create(bentHallData());
}

/// The same hall, turned, scaled and moved as a whole and not bent: exactly a similarity.
inline ProjectorData straightHallData(double scale, const Pose2& slam_from_blueprint) {
  ProjectorData data = bentHallData();
  data.info.scale = scale;
  for (std::size_t node = 0; node < data.node_slam.size(); ++node) {
    const Eigen::Vector2d turned = rotationMatrix(slam_from_blueprint.heading) * data.node_blueprint[node];
    data.node_slam[node] = {scale * turned + slam_from_blueprint.translation, slam_from_blueprint.heading};
  }
  return data;
}

}  // namespace cad2slam::test
