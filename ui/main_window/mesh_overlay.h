// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/services/solve_types.h"
#include "ui/views/marker.h"

#include <memory>

namespace cad2slam {

/// The mesh of a result as the views draw it, with the strain of each edge.
[[nodiscard]] std::shared_ptr<const MeshOverlay> meshInBlueprint(const SolveResult& result);
[[nodiscard]] std::shared_ptr<const MeshOverlay> meshInSlam(const SolveResult& result);

}  // namespace cad2slam
