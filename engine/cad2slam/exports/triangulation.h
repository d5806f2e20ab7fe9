// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "cad2slam/core/result.h"
#include "cad2slam/exports/triangle_mesh.h"
#include "cad2slam/projection/projector.h"

namespace cad2slam {

/// The projector as triangles with at most `most_vertices` vertices: two triangles for each tile, or for each block of
/// tiles where there are more. Between the vertices positions are linear; `max_deviation_m` says how far that is from
/// the projector on its tiles. kOutOfDomain where a triangle would turn over: such a mesh has no inverse.
[[nodiscard]] Result<TriangleMesh> triangulate(const Projector& projector, std::size_t most_vertices);

}  // namespace cad2slam
