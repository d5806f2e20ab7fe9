// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/projection/projector_arrays.h"

#include <algorithm>
#include <iterator>

namespace cad2slam {
namespace {

/// Each element of one container, converted, as the content of another.
template <class From, class To, class Convert>
void convertAll(const From& from, To& to, const Convert& convert) {
  to.clear();
  to.reserve(from.size());
  std::transform(from.begin(), from.end(), std::back_inserter(to), convert);
}

std::array<double, 2> rowOf(const Eigen::Vector2d& vector) {
  return {vector.x(), vector.y()};
}

Eigen::Vector2d vectorOf(const std::array<double, 2>& row) {
  return {row[0], row[1]};
}

}  // namespace

ProjectorArrays arraysOf(const ProjectorData& data) {
  ProjectorArrays arrays;
  convertAll(data.node_blueprint, arrays.node_blueprint, rowOf);
  convertAll(data.node_slam, arrays.node_slam, [](const Pose2& pose) {
    return std::array<double, 3>{pose.translation.x(), pose.translation.y(), pose.heading};
  });
  convertAll(data.node_stretch, arrays.node_stretch, rowOf);
  arrays.node_tile.assign(data.node_tile.begin(), data.node_tile.end());
  return arrays;
}

void setNodes(ProjectorData& data, const ProjectorArrays& arrays) {
  convertAll(arrays.node_blueprint, data.node_blueprint, vectorOf);
  convertAll(arrays.node_slam, data.node_slam, [](const std::array<double, 3>& row) {
    return Pose2{{row[0], row[1]}, row[2]};
  });
  convertAll(arrays.node_stretch, data.node_stretch, vectorOf);
  data.node_tile.assign(arrays.node_tile.begin(), arrays.node_tile.end());
}

}  // namespace cad2slam
