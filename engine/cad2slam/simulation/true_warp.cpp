// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/simulation/true_warp.h"

#include <algorithm>
#include <cmath>

namespace cad2slam {

Result<TrueWarp> TrueWarp::create(const Layout& layout, std::vector<Sample> samples) {
  if (!layout.first.allFinite() || !std::isfinite(layout.step_m) || layout.step_m <= 0.0) {
    return fail(ErrorCode::kMalformed, "The grid of a true warp needs a finite origin and a positive step");
  }
  if (layout.columns < 2 || layout.rows < 2 || layout.columns > kMaxSamplesPerSide ||
      layout.rows > kMaxSamplesPerSide) {
    return fail(ErrorCode::kMalformed, "The grid of a true warp needs 2 to 20000 rows and columns");
  }
  if (samples.size() != static_cast<std::size_t>(layout.columns) * static_cast<std::size_t>(layout.rows)) {
    return fail(ErrorCode::kMalformed, "The grid of a true warp does not hold rows x columns samples");
  }
  if (std::any_of(samples.begin(), samples.end(), [](const Sample& sample) {
        return std::isinf(sample.x) || std::isinf(sample.y) || std::isinf(sample.heading);
      })) {
    return fail(ErrorCode::kMalformed, "The grid of a true warp holds an infinite number");
  }
  return TrueWarp(layout, std::move(samples));
}

std::optional<Pose2> TrueWarp::slamFromBlueprint(const Pose2& pose_in_blueprint) const {
  const Eigen::Vector2d at = (pose_in_blueprint.translation - layout_.first) / layout_.step_m;
  if (!(at.x() >= 0.0 && at.y() >= 0.0 && at.x() <= layout_.columns - 1 && at.y() <= layout_.rows - 1)) return {};
  const int column = std::min(static_cast<int>(at.x()), layout_.columns - 2);
  const int row = std::min(static_cast<int>(at.y()), layout_.rows - 2);
  const double right = at.x() - column;
  const double up = at.y() - row;
  Eigen::Vector2d position = Eigen::Vector2d::Zero();
  Eigen::Vector2d direction = Eigen::Vector2d::Zero();  // headings are averaged as directions: they may wrap
  for (const int dr : {0, 1}) {
    for (const int dc : {0, 1}) {
      const double weight = (dc == 1 ? right : 1.0 - right) * (dr == 1 ? up : 1.0 - up);
      if (weight == 0.0) continue;
      const Sample& sample = samples_[static_cast<std::size_t>(row + dr) * static_cast<std::size_t>(layout_.columns) +
                                      static_cast<std::size_t>(column + dc)];
      const double heading = sample.heading;
      position += weight * Eigen::Vector2d(sample.x, sample.y);
      direction += weight * Eigen::Vector2d(std::cos(heading), std::sin(heading));
    }
  }
  const Pose2 pose{position, wrapAngle(pose_in_blueprint.heading + std::atan2(direction.y(), direction.x()))};
  if (!pose.isFinite()) return {};
  return pose;
}

}  // namespace cad2slam
