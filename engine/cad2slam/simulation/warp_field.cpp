// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/simulation/warp_field.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace cad2slam {
namespace {

constexpr double kStepM = 1.0;        // between knots of the route
constexpr double kRouteReachM = 4.0;  // within this distance of the route its error rules alone
constexpr double kAreaMin = 0.75;
constexpr double kAreaMax = 1.3;
constexpr double kWobbleLengthM = 10.0;

}  // namespace

WarpField::WarpField(const WarpRecipe& recipe, const std::vector<Eigen::Vector2d>& route, bool route_is_closed,
                     const std::vector<Eigen::Vector2d>& places, SeededRandom& random)
    : slam_from_plan_(recipe.slam_from_plan) {
  Eigen::Vector2d low = places.empty() ? Eigen::Vector2d::Zero() : places.front();
  Eigen::Vector2d high = low;
  for (const Eigen::Vector2d& place : places) {
    low = low.cwiseMin(place);
    high = high.cwiseMax(place);
  }
  center_ = 0.5 * (low + high);
  const double width = std::max(1.0, high.x() - low.x());
  curvature_ = recipe.bend_rad / width;
  addWaves(recipe.wave_m, recipe.wave_length_m, 4, random);
  addWaves(recipe.wobble_m, kWobbleLengthM, 6, random);
  layOutRoute(recipe, route, random);
  for (int attempt = 0; attempt < 40; ++attempt) {
    integrateRoute(route_is_closed);
    if (keepsAreas(places)) return;
    strength_ *= 0.85;
  }
}

void WarpField::addWaves(double amplitude_m, double shortest_m, int count, SeededRandom& random) {
  if (amplitude_m == 0.0) return;
  for (int i = 0; i < count; ++i) {
    const double number = 2.0 * kPi / (shortest_m * random.uniform(1.0, 2.2));
    const double direction = random.uniform(-kPi, kPi);
    const double push = random.uniform(-kPi, kPi);
    Wave wave;
    wave.wave_number = number * Eigen::Vector2d(std::cos(direction), std::sin(direction));
    wave.amplitude = amplitude_m / std::sqrt(count) * std::sqrt(2.0) * Eigen::Vector2d(std::cos(push), std::sin(push));
    wave.phase = random.uniform(-kPi, kPi);
    waves_.push_back(wave);
  }
}

void WarpField::layOutRoute(const WarpRecipe& recipe, const std::vector<Eigen::Vector2d>& route, SeededRandom& random) {
  if (recipe.heading_drift_rad == 0.0 && recipe.route_stretch == 0.0 && recipe.route_stretch_sigma == 0.0) return;
  // First-order Gauss-Markov noise: alike over the correlation length. Its integral over L wanders by
  // sigma sqrt(2 correlation L), which gives the deviation of the rate from that of the heading after 100 m.
  const double correlation = std::max(recipe.correlation_m, kStepM);
  const double rate_sigma = recipe.heading_drift_rad / std::sqrt(2.0 * correlation * 100.0);
  double rate = rate_sigma * random.normal();
  double stretch = recipe.route_stretch_sigma * random.normal();
  for (std::size_t i = 1; i < route.size(); ++i) {
    const Eigen::Vector2d leg = route[i] - route[i - 1];
    const int count = std::max(1, static_cast<int>(std::lround(leg.norm() / kStepM)));
    const double step_m = leg.norm() / count;
    const double keep = std::exp(-step_m / correlation);
    const double renew = std::sqrt(1.0 - keep * keep);
    for (int k = 0; k < count; ++k) {
      rate = keep * rate + renew * rate_sigma * random.normal();
      stretch = keep * stretch + renew * recipe.route_stretch_sigma * random.normal();
      const Eigen::Vector2d from = route[i - 1] + leg * (static_cast<double>(k) / count);
      steps_.push_back({from, from + leg / count, rate, recipe.route_stretch + stretch});
    }
  }
}

void WarpField::integrateRoute(bool closed) {
  knots_.clear();
  if (steps_.empty()) return;
  RouteKnot knot{steps_.front().from, 0.0, steps_.front().from};
  knots_.push_back(knot);
  for (const RouteStep& step : steps_) {
    const Eigen::Vector2d way = step.to - step.from;
    const double turn = strength_ * step.heading_rate * way.norm();
    knot.place = step.to;
    knot.drifted += (1.0 + strength_ * step.stretch) * (rotationMatrix(knot.heading_error + 0.5 * turn) * way);
    knot.heading_error += turn;
    knots_.push_back(knot);
  }
  if (!closed) return;
  // The loop closure spreads what is left over evenly along the way, first the heading, then the place.
  const auto count = static_cast<double>(knots_.size() - 1);
  const double heading_left = knots_.back().heading_error;
  for (std::size_t i = 1; i < knots_.size(); ++i) {
    const RouteStep& step = steps_[i - 1];
    knots_[i].heading_error -= heading_left * static_cast<double>(i) / count;
    const double heading = 0.5 * (knots_[i - 1].heading_error + knots_[i].heading_error);
    knots_[i].drifted =
        knots_[i - 1].drifted + (1.0 + strength_ * step.stretch) * (rotationMatrix(heading) * (step.to - step.from));
  }
  const Eigen::Vector2d place_left = knots_.back().drifted - knots_.front().drifted;
  for (std::size_t i = 1; i < knots_.size(); ++i) knots_[i].drifted -= place_left * static_cast<double>(i) / count;
}

Eigen::Vector2d WarpField::driftedAlongRoute(const Eigen::Vector2d& point) const {
  if (knots_.empty()) return point;
  // Each knot carries its surroundings along rigidly. The weights fall off like a power of the distance, so that the
  // change from one leg of the route to another is as wide as the legs are apart.
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  double weights = 0.0;
  for (const RouteKnot& knot : knots_) {
    const Eigen::Vector2d offset = point - knot.place;
    const double near = 1.0 / (1.0 + offset.squaredNorm() / (kRouteReachM * kRouteReachM));
    const double weight = near * near;
    sum += weight * (knot.drifted + rotationMatrix(knot.heading_error) * offset);
    weights += weight;
  }
  return sum / weights;
}

Eigen::Vector2d WarpField::bent(const Eigen::Vector2d& point) const {
  const double curvature = strength_ * curvature_;
  const Eigen::Vector2d offset = point - center_;
  const double turn = curvature * offset.x();
  // The building's x axis becomes an arc; lines across it stay straight.
  const double along = std::abs(turn) < 1e-6 ? offset.x() : std::sin(turn) / curvature;
  const double across = std::abs(turn) < 1e-6 ? 0.5 * turn * offset.x() : (1.0 - std::cos(turn)) / curvature;
  return center_ + Eigen::Vector2d(along - offset.y() * std::sin(turn), across + offset.y() * std::cos(turn));
}

Eigen::Vector2d WarpField::slamFromPlan(const Eigen::Vector2d& point_in_plan) const {
  Eigen::Vector2d point = driftedAlongRoute(point_in_plan);
  for (const Wave& wave : waves_) {
    point += strength_ * wave.amplitude * std::sin(wave.wave_number.dot(point_in_plan) + wave.phase);
  }
  return slam_from_plan_ * bent(point);
}

Eigen::Matrix2d WarpField::jacobian(const Eigen::Vector2d& point_in_plan) const {
  constexpr double kStep = 1e-4;  // error of the central difference: about 1e-9
  Eigen::Matrix2d columns;
  for (int axis = 0; axis < 2; ++axis) {
    const Eigen::Vector2d step = kStep * Eigen::Vector2d::Unit(axis);
    columns.col(axis) =
        (slamFromPlan(Eigen::Vector2d(point_in_plan + step)) - slamFromPlan(Eigen::Vector2d(point_in_plan - step))) /
        (2.0 * kStep);
  }
  return columns;
}

Pose2 WarpField::slamFromPlan(const Pose2& pose_in_plan) const {
  const Eigen::Matrix2d j = jacobian(pose_in_plan.translation);
  const double turn = std::atan2(j(1, 0) - j(0, 1), j(0, 0) + j(1, 1));
  return {slamFromPlan(pose_in_plan.translation), wrapAngle(pose_in_plan.heading + turn)};
}

bool WarpField::keepsAreas(const std::vector<Eigen::Vector2d>& places) const {
  return std::all_of(places.begin(), places.end(), [&](const Eigen::Vector2d& place) {
    const double area = jacobian(place).determinant();
    return area >= kAreaMin && area <= kAreaMax;
  });
}

}  // namespace cad2slam
