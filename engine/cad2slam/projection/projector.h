// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "cad2slam/core/result.h"
#include "cad2slam/projection/projector_arrays.h"
#include "cad2slam/projection/projector_data.h"

namespace cad2slam {

enum class ProjectionStatus : std::uint8_t {
  kInside,        ///< the query lies on a tile of the mesh
  kExtrapolated,  ///< beyond the mesh, answered rigidly because the caller asked for it
  kOutside,       ///< beyond the mesh and not answered
  kFolded,        ///< the mesh folds or overlaps here: there is no unique answer
  kInvalid,       ///< the query is not finite
};

/// Answer to one query. `pose` is NaN unless ok().
struct Projection {
  Pose2 pose;  ///< metres, radians in [-pi, pi)
  ProjectionStatus status = ProjectionStatus::kInvalid;

  [[nodiscard]] bool ok() const {
    return status == ProjectionStatus::kInside || status == ProjectionStatus::kExtrapolated;
  }
};

/// Projects poses between the blueprint frame and the SLAM frame through one solved mesh (paper eq. 1 and 2).
///
/// Each node i predicts p_slam = t_i + s R(theta_i) diag(exp(a_i)) (p - t_i^b); positions are the weighted mean of the
/// predictions, and a heading is turned by the same weighted mean of the linear parts (for the rigid model this is the
/// paper's circular mean). The inverse is the true inverse of that function.
///
/// Immutable: share between threads without locks. No query allocates or throws, and its cost does not depend on the
/// number of nodes. Copies share the nodes.
class Projector {
 public:
  /// kMalformed: sizes differ, a number is not finite, a tile stands twice, a centre lies off its tile, |stretch| > 5.
  /// Each array is freed as soon as it has been used: with a million nodes it matters how much is there at once.
  [[nodiscard]] static Result<Projector> create(const ProjectorInfo& info, ProjectorArrays&& arrays);
  [[nodiscard]] static Result<Projector> create(const ProjectorData& data);

  [[nodiscard]] const ProjectorInfo& info() const noexcept;
  [[nodiscard]] std::size_t nodeCount() const noexcept;
  /// Tiles on which the forward function turns over (determinant of its Jacobian <= 0 at a centre or corner).
  [[nodiscard]] std::size_t foldedTileCount() const noexcept;

  [[nodiscard]] Projection slamFromBlueprint(const Pose2& pose_in_blueprint, OutsidePolicy outside) const noexcept;
  [[nodiscard]] Projection blueprintFromSlam(const Pose2& pose_in_slam, OutsidePolicy outside) const noexcept;
  /// As above; saves the search where the answer is near `hint_in_blueprint` [m], as along a path. A bad hint costs
  /// time but changes nothing.
  [[nodiscard]] Projection blueprintFromSlam(const Pose2& pose_in_slam, OutsidePolicy outside,
                                             const Eigen::Vector2d& hint_in_blueprint) const noexcept;
  /// As above, with the policy the projector was made with.
  [[nodiscard]] Projection slamFromBlueprint(const Pose2& pose_in_blueprint) const noexcept;
  [[nodiscard]] Projection blueprintFromSlam(const Pose2& pose_in_slam) const noexcept;

  /// `count` poses at once on up to `threads` threads (0: one for each core). `out` may not overlap `in`.
  void slamFromBlueprint(const Pose2* in, Projection* out, std::size_t count, OutsidePolicy outside,
                         unsigned threads = 1) const;
  void blueprintFromSlam(const Pose2* in, Projection* out, std::size_t count, OutsidePolicy outside,
                         unsigned threads = 1) const;

  /// d position_in_slam / d position_in_blueprint at a place of the blueprint [m], extrapolated where it is outside.
  [[nodiscard]] Eigen::Matrix2d jacobian(const Eigen::Vector2d& point_in_blueprint) const noexcept;

  /// Distance [m] from a place of the blueprint to the nearest tile of the mesh; 0 on a tile.
  [[nodiscard]] double distanceToMesh(const Eigen::Vector2d& point_in_blueprint) const noexcept;

  /// Middles of all tiles [m] in the blueprint frame, in no particular order.
  [[nodiscard]] std::vector<Eigen::Vector2d> tileMiddles() const;

 private:
  class Impl;
  explicit Projector(std::shared_ptr<const Impl> impl) : impl_(std::move(impl)) {}
  std::shared_ptr<const Impl> impl_;
};

}  // namespace cad2slam
