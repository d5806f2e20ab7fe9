// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cad2slam/core/result.h"
#include "cad2slam/projection/projector.h"

namespace cad2slam {

/// From the SLAM map of one robot into that of another, through the blueprint that both share.
class RobotToRobot {
 public:
  /// kOutOfDomain unless both projectors were made for the same picture of the blueprint, by its SHA-256, with the same
  /// frame.
  [[nodiscard]] static Result<RobotToRobot> create(const Projector& from, const Projector& to);

  /// `outside` holds for both ways. The status is that of the way that failed, or extrapolated where one of both was.
  [[nodiscard]] Projection project(const Pose2& pose_in_first_slam, OutsidePolicy outside) const noexcept;
  /// With the policies the projectors were made with.
  [[nodiscard]] Projection project(const Pose2& pose_in_first_slam) const noexcept;

 private:
  RobotToRobot(const Projector& from, const Projector& to) : from_(from), to_(to) {}

  Projector from_;
  Projector to_;
};

}  // namespace cad2slam
