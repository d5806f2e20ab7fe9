// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0

// The smallest program of a robot. It calls everything that such programs call, so that the linker takes it all in.
#include <cstdio>
#include <utility>

#include "cad2slam/io/projector_file.h"

// What a control loop calls promises not to throw.
using cad2slam::Pose2;
using cad2slam::Projector;
static_assert(noexcept(std::declval<const Projector&>().slamFromBlueprint(std::declval<const Pose2&>())));
static_assert(noexcept(std::declval<const Projector&>().blueprintFromSlam(std::declval<const Pose2&>())));
static_assert(noexcept(std::declval<const Projector&>().jacobian(std::declval<const Eigen::Vector2d&>())));

int main() {
  const cad2slam::Result<cad2slam::Projector> missing = cad2slam::loadProjector("no such file.c2s");
  if (missing) {
    const cad2slam::Projection projection = missing->slamFromBlueprint(cad2slam::Pose2());
    const cad2slam::Projection back = missing->blueprintFromSlam(projection.pose);
    return back.ok() ? 1 : 2;
  }
  std::printf("%s\n", missing.error().sentence().c_str());
  return missing.error().code == cad2slam::ErrorCode::kNotFound ? 0 : 1;
}
