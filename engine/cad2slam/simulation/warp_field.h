// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include <vector>

#include "cad2slam/geometry/pose2.h"
#include "cad2slam/geometry/similarity2.h"
#include "cad2slam/simulation/seeded_random.h"

namespace cad2slam {

/// How a SLAM map is bent. All strengths 0 is a rigid motion.
struct WarpRecipe {
  double heading_drift_rad = 0.0;    ///< deviation of the heading error after 100 m of the route
  double route_stretch = 0.0;        ///< mean of the error of lengths along the route, e.g. -0.03: 3 % too short
  double route_stretch_sigma = 0.0;  ///< its deviation from place to place
  double correlation_m = 15.0;       ///< way along the route on which errors stay alike
  double bend_rad = 0.0;             ///< the building is bent by this angle from its left to its right end
  double wave_m = 0.0;               ///< amplitude of smooth displacements
  double wave_length_m = 30.0;       ///< shortest wave length among them
  double wobble_m = 0.0;             ///< the same at the scale of rooms: 10 m
  Pose2 slam_from_plan;              ///< where the SLAM map puts the building before it is bent
};

/// A smooth, invertible function from the plan of a building to a SLAM map. It is made of what SLAM does, not of the
/// mesh that is to find it: errors of heading and length along the way the robot drove (with the loop closed where the
/// way ends at its start), a bend of the whole building, and smooth displacements.
class WarpField {
 public:
  /// `route`: the way of the robot in the plan frame [m]. Too strong warps are weakened step by step until the ratio of
  /// areas stays within [0.75, 1.3] at every one of `places`, so the function is invertible there.
  WarpField(const WarpRecipe& recipe, const std::vector<Eigen::Vector2d>& route, bool route_is_closed,
            const std::vector<Eigen::Vector2d>& places, SeededRandom& random);

  [[nodiscard]] Eigen::Vector2d slamFromPlan(const Eigen::Vector2d& point_in_plan) const;
  /// The heading is turned by the rotation nearest to the Jacobian.
  [[nodiscard]] Pose2 slamFromPlan(const Pose2& pose_in_plan) const;
  [[nodiscard]] Eigen::Matrix2d jacobian(const Eigen::Vector2d& point_in_plan) const;
  /// What is left of the recipe's strengths, in (0, 1].
  [[nodiscard]] double strength() const { return strength_; }

 private:
  /// Error of the map near one place of the route, as a rigid motion.
  struct RouteKnot {
    Eigen::Vector2d place = Eigen::Vector2d::Zero();
    double heading_error = 0.0;
    Eigen::Vector2d drifted = Eigen::Vector2d::Zero();
  };
  struct Wave {
    Eigen::Vector2d wave_number = Eigen::Vector2d::Zero();  ///< [rad/m]
    Eigen::Vector2d amplitude = Eigen::Vector2d::Zero();    ///< [m]
    double phase = 0.0;
  };
  struct RouteStep {
    Eigen::Vector2d from = Eigen::Vector2d::Zero();
    Eigen::Vector2d to = Eigen::Vector2d::Zero();
    double heading_rate = 0.0;  ///< [rad/m]
    double stretch = 0.0;
  };

  void addWaves(double amplitude_m, double shortest_m, int count, SeededRandom& random);
  void layOutRoute(const WarpRecipe& recipe, const std::vector<Eigen::Vector2d>& route, SeededRandom& random);
  void integrateRoute(bool closed);
  [[nodiscard]] Eigen::Vector2d driftedAlongRoute(const Eigen::Vector2d& point) const;
  [[nodiscard]] Eigen::Vector2d bent(const Eigen::Vector2d& point) const;
  [[nodiscard]] bool keepsAreas(const std::vector<Eigen::Vector2d>& places) const;

  Pose2 slam_from_plan_;
  Eigen::Vector2d center_ = Eigen::Vector2d::Zero();
  double curvature_ = 0.0;  ///< of the bend at full strength [rad/m]
  double strength_ = 1.0;
  std::vector<RouteStep> steps_;
  std::vector<RouteKnot> knots_;
  std::vector<Wave> waves_;
};

}  // namespace cad2slam
