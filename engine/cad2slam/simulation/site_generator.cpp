// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/simulation/site_generator.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace cad2slam {
namespace {

constexpr double kMaxSidePx = 30'000.0;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

double distanceToRoute(const std::vector<Eigen::Vector2d>& route, const Eigen::Vector2d& point) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < route.size(); ++i) {
    const Eigen::Vector2d leg = route[i] - route[i - 1];
    const double along = std::clamp((point - route[i - 1]).dot(leg) / leg.squaredNorm(), 0.0, 1.0);
    nearest = std::min(nearest, (route[i - 1] + along * leg - point).norm());
  }
  return nearest;
}

/// Each next corner is the one farthest from all before it: an even spread at every count.
std::vector<Eigen::Vector2d> pickSpread(const std::vector<Eigen::Vector2d>& corners, std::size_t count,
                                        SeededRandom& random) {
  std::vector<Eigen::Vector2d> picked;
  std::vector<double> distance(corners.size(), std::numeric_limits<double>::infinity());
  auto next = static_cast<std::size_t>(random.integer(0, static_cast<int>(corners.size()) - 1));
  while (picked.size() < count) {
    picked.push_back(corners[next]);
    distance[next] = -1.0;
    double farthest = -1.0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      if (distance[i] < 0.0) continue;
      distance[i] = std::min(distance[i], (corners[i] - picked.back()).norm() * random.uniform(0.85, 1.0));
      if (distance[i] > farthest) {
        farthest = distance[i];
        next = i;
      }
    }
  }
  return picked;
}

void shuffle(std::vector<Eigen::Vector2d>& corners, SeededRandom& random) {
  for (std::size_t i = corners.size(); i > 1; --i) {
    std::swap(corners[i - 1], corners[static_cast<std::size_t>(random.integer(0, static_cast<int>(i) - 1))]);
  }
}

std::vector<Eigen::Vector2d> pickCorners(const SitePlan& plan, std::vector<Eigen::Vector2d> corners,
                                         const AnchorRecipe& recipe, SeededRandom& random) {
  const std::size_t count = std::min(corners.size(), static_cast<std::size_t>(std::max(0, recipe.count)));
  if (count == 0) return {};
  const auto keep_nearest = [&](std::size_t kept, const auto& distance) {
    std::stable_sort(corners.begin(), corners.end(),
                     [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return distance(a) < distance(b); });
    corners.resize(std::clamp(kept, count, corners.size()));
  };
  switch (recipe.layout) {
    case AnchorLayout::kSpread:
      return pickSpread(corners, count, random);
    case AnchorLayout::kRandom:
      break;
    case AnchorLayout::kClustered: {
      const std::vector<Eigen::Vector2d> centers = pickSpread(corners, std::min<std::size_t>(count, 3), random);
      keep_nearest(count + count / 2, [&](const Eigen::Vector2d& corner) {
        double nearest = std::numeric_limits<double>::infinity();
        for (const Eigen::Vector2d& center : centers) nearest = std::min(nearest, (corner - center).norm());
        return nearest;
      });
      break;
    }
    case AnchorLayout::kAlongRoute:
      keep_nearest(corners.size() / 3,
                   [&](const Eigen::Vector2d& corner) { return distanceToRoute(plan.route, corner); });
      return pickSpread(corners, count, random);
  }
  shuffle(corners, random);
  corners.resize(count);
  return corners;
}

}  // namespace

Result<Building> makeBuilding(const BuildingRecipe& recipe) {
  const Eigen::Vector2d& size = recipe.plan.size_m;
  if (!size.allFinite() || size.minCoeff() < 5.0 || !std::isfinite(recipe.plan_scale) || recipe.plan_scale <= 0.0 ||
      !std::isfinite(recipe.blueprint_turn_rad) || !(recipe.margin_m >= 0.0)) {
    return fail(ErrorCode::kOutOfDomain, "A building needs sides of at least 5 m and a positive scale");
  }
  SeededRandom random(recipe.seed);
  const SitePlan plan = makeSitePlan(recipe.plan, random);

  Similarity2 blueprint_from_plan;
  blueprint_from_plan.scale = 1.0 / recipe.plan_scale;
  blueprint_from_plan.heading = recipe.blueprint_turn_rad;
  Eigen::Vector2d low = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Vector2d high = -low;
  const Box outline = Box{Eigen::Vector2d::Zero(), size}.grownBy(plan.outer_wall_m);
  for (const double x : {outline.low.x(), outline.high.x()}) {
    for (const double y : {outline.low.y(), outline.high.y()}) {
      const Eigen::Vector2d corner = blueprint_from_plan * Eigen::Vector2d(x, y);
      low = low.cwiseMin(corner);
      high = high.cwiseMax(corner);
    }
  }
  blueprint_from_plan.translation = recipe.blueprint_origin - low + Eigen::Vector2d::Constant(recipe.margin_m);
  const Eigen::Vector2d size_px =
      (high - low + Eigen::Vector2d::Constant(2.0 * recipe.margin_m)) / recipe.resolution_m_per_px;
  if (!size_px.allFinite() || size_px.minCoeff() < 1.0 || size_px.maxCoeff() > kMaxSidePx) {
    return fail(ErrorCode::kOutOfDomain, "The resolution of the blueprint does not fit the size of the building");
  }
  const Result<MapFrame> frame =
      MapFrame::create(recipe.resolution_m_per_px, static_cast<int>(std::ceil(size_px.x())),
                       static_cast<int>(std::ceil(size_px.y())), {recipe.blueprint_origin, 0.0});
  if (!frame) return failAs(frame);
  return Building{plan, blueprint_from_plan, drawPlan(plan, *frame, blueprint_from_plan)};
}

std::vector<Eigen::Vector2d> freePlaces(const SitePlan& plan, double spacing_m) {
  std::vector<Eigen::Vector2d> places;
  for (double y = 0.5 * spacing_m; y < plan.size_m.y(); y += spacing_m) {
    for (double x = 0.5 * spacing_m; x < plan.size_m.x(); x += spacing_m) {
      if (plan.isFree({x, y})) places.emplace_back(x, y);
    }
  }
  return places;
}

AnchorList placeAnchors(const Building& building, const WarpField& warp, const AnchorRecipe& recipe,
                        SeededRandom& random, const CornerFilter& is_visible) {
  std::vector<Eigen::Vector2d> corners = building.plan.corners();
  if (is_visible) {
    corners.erase(std::remove_if(corners.begin(), corners.end(),
                                 [&](const Eigen::Vector2d& corner) { return !is_visible(corner); }),
                  corners.end());
  }
  corners = pickCorners(building.plan, std::move(corners), recipe, random);
  AnchorList anchors;
  for (const Eigen::Vector2d& corner : corners) {
    Anchor anchor;
    anchor.id = static_cast<AnchorId>(anchors.size() + 1);
    anchor.in_blueprint = building.blueprint_from_plan * corner + recipe.blueprint_click_m * random.normal2();
    const Eigen::Vector2d as_built = corner + recipe.as_built_m * random.normal2();
    anchor.in_slam = warp.slamFromPlan(as_built) + recipe.slam_click_m * random.normal2();
    anchors.push_back(anchor);
  }
  for (int i = 0; i < recipe.outliers && !anchors.empty(); ++i) {
    const auto which = static_cast<std::size_t>(random.integer(0, static_cast<int>(anchors.size()) - 1));
    const double direction = random.uniform(-kPi, kPi);
    anchors[which].in_slam += recipe.outlier_m * Eigen::Vector2d(std::cos(direction), std::sin(direction));
  }
  return anchors;
}

Result<TrueWarp> sampleTrueWarp(const Building& building, const WarpField& warp, double step_m) {
  const OccupancyGrid& blueprint = building.blueprint;
  const MapFrame& frame = blueprint.frame();
  if (!std::isfinite(step_m) || step_m <= 0.0) return fail(ErrorCode::kOutOfDomain, "The step must be positive");
  const double width_m = frame.width() * frame.resolution();
  const double height_m = frame.height() * frame.resolution();
  TrueWarp::Layout layout;
  layout.first = frame.metricFromCorner().translation;
  layout.step_m = step_m;
  layout.columns = static_cast<int>(std::ceil(std::min(width_m / step_m, 1e6))) + 1;
  layout.rows = static_cast<int>(std::ceil(std::min(height_m / step_m, 1e6))) + 1;
  if (std::max(layout.columns, layout.rows) > TrueWarp::kMaxSamplesPerSide) {
    return fail(ErrorCode::kOutOfDomain, "The step is too small for the size of the blueprint");
  }
  // All four samples around a free pixel are needed to read the warp there.
  const auto columns = static_cast<std::size_t>(layout.columns);
  std::vector<bool> needed(columns * static_cast<std::size_t>(layout.rows), false);
  for (int row = 0; row < frame.height(); ++row) {
    for (int column = 0; column < frame.width(); ++column) {
      if (blueprint.at(column, row) != CellState::kFree) continue;
      const Eigen::Vector2d at = (frame.metricFromPixel({column + 0.5, row + 0.5}) - layout.first) / step_m;
      const std::size_t first = static_cast<std::size_t>(at.y()) * columns + static_cast<std::size_t>(at.x());
      for (const std::size_t sample : {first, first + 1, first + columns, first + columns + 1}) needed[sample] = true;
    }
  }
  const Similarity2 plan_from_blueprint = building.blueprint_from_plan.inverse();
  std::vector<TrueWarp::Sample> samples;
  samples.reserve(needed.size());
  for (std::size_t i = 0; i < needed.size(); ++i) {
    Pose2 pose{{kNaN, kNaN}, kNaN};
    if (needed[i]) {
      const Eigen::Vector2d place =
          layout.first + step_m * Eigen::Vector2d(static_cast<double>(i % columns), static_cast<double>(i / columns));
      pose = warp.slamFromPlan(plan_from_blueprint * Pose2{place, 0.0});
    }
    samples.push_back({static_cast<float>(pose.translation.x()), static_cast<float>(pose.translation.y()),
                       static_cast<float>(pose.heading)});
  }
  return TrueWarp::create(layout, std::move(samples));
}

Pose2 GeneratedSite::slamFromBlueprint(const Pose2& pose_in_blueprint) const {
  return warp.slamFromPlan(building.blueprint_from_plan.inverse() * pose_in_blueprint);
}

SiteRecipe randomSiteRecipe(std::uint64_t seed) {
  SeededRandom random(seed);
  SiteRecipe recipe;
  recipe.seed = random.seed();
  BuildingRecipe& building = recipe.building;
  building.seed = random.seed();

  const std::array<SiteKind, 10> kinds = {
      SiteKind::kFlat,     SiteKind::kFlat,     SiteKind::kOffice,   SiteKind::kOffice, SiteKind::kOffice,
      SiteKind::kCorridor, SiteKind::kCorridor, SiteKind::kCorridor, SiteKind::kHall,   SiteKind::kHall};
  building.plan.kind = kinds[static_cast<std::size_t>(random.integer(0, 9))];
  const double stretch = std::exp(random.uniform(0.0, 1.0));  // sizes are spread evenly in proportion
  switch (building.plan.kind) {
    case SiteKind::kFlat:
      building.plan.size_m = {random.uniform(8.0, 16.0), random.uniform(7.0, 11.0)};
      break;
    case SiteKind::kOffice:
      building.plan.size_m = {random.uniform(15.0, 35.0) * stretch, random.uniform(11.0, 22.0) * stretch};
      break;
    case SiteKind::kCorridor:
      building.plan.shape = static_cast<CorridorShape>(random.integer(0, 3));
      building.plan.size_m = {random.uniform(28.0, 44.0) * stretch, random.uniform(22.0, 30.0) * stretch};
      if (building.plan.shape == CorridorShape::kStraight) building.plan.size_m.y() = random.uniform(13.0, 17.0);
      break;
    case SiteKind::kHall:
      building.plan.size_m = {random.uniform(20.0, 44.0) * stretch, random.uniform(18.0, 26.0) * stretch};
      break;
  }
  const double size = building.plan.size_m.maxCoeff();
  building.resolution_m_per_px = std::max(0.04, size / 900.0);
  building.blueprint_origin = {random.uniform(-30.0, 30.0), random.uniform(-30.0, 30.0)};
  const double fate = random.uniform();
  building.plan_scale = fate < 0.5   ? std::exp(0.002 * random.normal())
                        : fate < 0.8 ? random.uniform(0.94, 1.06)
                                     : std::exp(random.uniform(-0.5, 0.5));
  building.resolution_m_per_px /= building.plan_scale;
  if (random.chance(0.15)) building.blueprint_turn_rad = random.uniform(-kPi, kPi);

  WarpRecipe& warp = recipe.warp;
  if (random.chance(0.75)) {
    warp.heading_drift_rad = 0.01 * std::exp(random.uniform(0.0, 2.5));
    warp.route_stretch_sigma = random.uniform(0.0, 0.03);
    warp.correlation_m = random.uniform(8.0, 30.0);
    if (random.chance(0.5)) warp.route_stretch = random.uniform(-0.05, 0.02);
  }
  if (random.chance(0.4)) warp.bend_rad = random.uniform(-0.35, 0.35) * std::min(1.0, size / 60.0);
  if (random.chance(0.5)) {
    warp.wave_length_m = random.uniform(0.35, 1.2) * size;
    warp.wave_m = random.uniform(0.0, 0.02) * warp.wave_length_m;
  }
  warp.wobble_m = random.uniform(0.0, 0.08);
  warp.slam_from_plan = {{random.uniform(-40.0, 40.0), random.uniform(-40.0, 40.0)}, random.uniform(-kPi, kPi)};

  AnchorRecipe& anchors = recipe.anchors;
  anchors.count = static_cast<int>(std::lround(4.0 * std::exp(random.uniform(0.0, 2.7))));
  anchors.layout = static_cast<AnchorLayout>(random.integer(0, 3));
  anchors.blueprint_click_m = random.uniform(0.7, 1.6) * building.resolution_m_per_px;
  anchors.slam_click_m = random.uniform(0.7, 1.6) * 0.05;
  anchors.as_built_m = random.uniform(0.0, 0.05);
  return recipe;
}

Result<GeneratedSite> generateSite(const SiteRecipe& recipe) {
  Result<Building> building = makeBuilding(recipe.building);
  if (!building) return failAs(building);
  SeededRandom random(recipe.seed);
  const double spacing = std::max(1.0, building->plan.size_m.norm() / 60.0);
  WarpField warp(recipe.warp, building->plan.route, building->plan.route_is_closed, freePlaces(building->plan, spacing),
                 random);
  AnchorList anchors = placeAnchors(*building, warp, recipe.anchors, random);
  return GeneratedSite{recipe, std::move(*building), std::move(warp), std::move(anchors)};
}

}  // namespace cad2slam
