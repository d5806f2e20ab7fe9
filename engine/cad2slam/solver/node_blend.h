// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include <array>
#include <cstddef>

#include "cad2slam/mesh/mesh.h"

namespace cad2slam {

/// The nodes that predict a place of the blueprint, with their weights (they sum to 1).
struct NodeBlend {
  static constexpr std::size_t kCapacity = 9;
  std::array<NodeIndex, kCapacity> nodes;
  std::array<double, kCapacity> weights;
  std::size_t count = 0;
};

/// Only the node whose centre is nearest, as the paper ties an anchor to the mesh (eq. 4).
[[nodiscard]] NodeBlend nearestNodeBlend(const Mesh& mesh, const Eigen::Vector2d& point_in_blueprint);

/// The blend of the projector's smooth weights: quadratic B-splines of the tile lattice, renormalised over existing
/// nodes; beyond the mesh the weights of its nearest place.
[[nodiscard]] NodeBlend smoothBlend(const Mesh& mesh, const Eigen::Vector2d& point_in_blueprint);

}  // namespace cad2slam
