// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cad2slam/anchors/anchor.h"
#include "cad2slam/core/result.h"
#include "cad2slam/mesh/mesh.h"
#include "cad2slam/projection/projector.h"
#include "cad2slam/projection/projector_data.h"
#include "cad2slam/solver/solution.h"

namespace cad2slam {

/// What a projector should do and say beyond the solved mesh.
struct ProjectorOptions {
  BlendWeights weights = BlendWeights::kSmooth;
  double radius_m = 4.0;
  OutsidePolicy outside = OutsidePolicy::kError;
  FrameInfo blueprint;
  FrameInfo slam;
  std::string creator;
  std::string created;  ///< ISO 8601 UTC; empty leaves it out
  std::string project;
  std::string note;
};

/// The projector of a solution, as a value ready to be written. Adds check poses and quality numbers.
[[nodiscard]] Result<ProjectorData> makeProjectorData(const Mesh& mesh, const Solution& solution,
                                                      const AnchorList& anchors, const ProjectorOptions& options);

/// Only the function, for previews.
[[nodiscard]] Result<Projector> makeProjector(const Mesh& mesh, const Solution& solution,
                                              BlendWeights weights = BlendWeights::kSmooth);

}  // namespace cad2slam
