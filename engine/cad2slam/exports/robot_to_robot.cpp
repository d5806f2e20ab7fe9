// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/exports/robot_to_robot.h"

#include <algorithm>

namespace cad2slam {
namespace {

bool sameFrame(const FrameInfo& a, const FrameInfo& b) {
  return a.resolution_m_per_px == b.resolution_m_per_px && a.width_px == b.width_px && a.height_px == b.height_px &&
         a.metric_from_corner.translation == b.metric_from_corner.translation &&
         a.metric_from_corner.heading == b.metric_from_corner.heading;
}

/// The answer of the second way, with the worse status of both.
Projection chained(const Projection& in_blueprint, const Projector& to, OutsidePolicy outside) {
  if (!in_blueprint.ok()) return in_blueprint;
  Projection answer = to.slamFromBlueprint(in_blueprint.pose, outside);
  if (answer.ok()) answer.status = std::max(answer.status, in_blueprint.status);
  return answer;
}

}  // namespace

Result<RobotToRobot> RobotToRobot::create(const Projector& from, const Projector& to) {
  const FrameInfo& first = from.info().blueprint;
  const FrameInfo& second = to.info().blueprint;
  if (first.image_sha256.empty() || second.image_sha256.empty()) {
    return fail(ErrorCode::kOutOfDomain, "a projector does not say which blueprint it was made for");
  }
  if (first.image_sha256 != second.image_sha256) {
    return fail(ErrorCode::kOutOfDomain, "the projectors were made for different blueprints (SHA-256 " +
                                             first.image_sha256.substr(0, 12) + "... and " +
                                             second.image_sha256.substr(0, 12) + "...)");
  }
  if (!sameFrame(first, second)) {
    return fail(ErrorCode::kOutOfDomain,
                "the projectors were made for the same blueprint with different resolutions or origins");
  }
  return RobotToRobot(from, to);
}

Projection RobotToRobot::project(const Pose2& pose_in_first_slam, OutsidePolicy outside) const noexcept {
  return chained(from_.blueprintFromSlam(pose_in_first_slam, outside), to_, outside);
}

Projection RobotToRobot::project(const Pose2& pose_in_first_slam) const noexcept {
  return chained(from_.blueprintFromSlam(pose_in_first_slam), to_, to_.info().outside);
}

}  // namespace cad2slam
