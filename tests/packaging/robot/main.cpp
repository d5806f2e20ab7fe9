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

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const cad2slam::Result<cad2slam::Projector> missing = cad2slam::loadProjector("no such file.c2s");
  if (missing || missing.error().code != cad2slam::ErrorCode::kNotFound) return 1;
  std::printf("%s\n", missing.error().sentence().c_str());

  const cad2slam::Result<cad2slam::Projector> projector = cad2slam::loadProjector(argv[1]);
  if (!projector) {
    std::printf("%s\n", projector.error().sentence().c_str());
    return 1;
  }
  const Pose2 start{{0.75, 0.25}, 0.0};
  const cad2slam::Projection there = projector->slamFromBlueprint(start);
  const cad2slam::Projection back = projector->blueprintFromSlam(there.pose);
  std::printf("%.3f %.3f %.3f\n", there.pose.translation.x(), there.pose.translation.y(), there.pose.heading);
  return there.ok() && back.ok() && (back.pose.translation - start.translation).norm() < 1e-6 ? 0 : 1;
}
