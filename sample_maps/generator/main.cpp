// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0

// Makes the three sample sites: cad2slam_sample_generator [OUTPUT_FOLDER [SITE]]. The same program gives the same
// files.
#include "cad2slam/io/anchors_csv.h"
#include "cad2slam/io/map_file.h"
#include "cad2slam/io/true_warp_file.h"
#include "cad2slam/simulation/site_generator.h"
#include "furnished_world.h"
#include "plan_drawing.h"
#include "slam_mapper.h"

#include <Eigen/LU>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

namespace cad2slam::samples {
namespace {

constexpr double kSlamResolution = 0.05;
constexpr double kClickPx = 1.2;  // deviation of a click along each axis

struct SlamRecipe {
  WarpRecipe warp;
  SensorModel sensor;
  AnchorLayout anchor_layout = AnchorLayout::kSpread;
  int anchor_count = 30;
  std::uint64_t seed = 1;
};

struct SampleSite {
  std::string name;
  std::string title;
  BuildingRecipe building;
  std::vector<SlamRecipe> slam_maps;
};

WarpRecipe turned(double x, double y, double degrees) {
  WarpRecipe warp;
  warp.slam_from_plan = {{x, y}, degrees * kPi / 180.0};
  return warp;
}

/// 45 x 25 m; the plan claims to be to scale and is.
SampleSite officeSite() {
  SampleSite site{"office", "OFFICE  LEVEL 2  1:100", {}, {}};
  site.building.plan.kind = SiteKind::kOffice;
  site.building.plan.size_m = {45.0, 25.0};
  site.building.resolution_m_per_px = 0.025;
  site.building.blueprint_origin = {-10.0, -5.0};
  site.building.seed = 7;
  SlamRecipe loop;
  loop.warp = turned(21.0, 12.5, 168.0);
  loop.warp.heading_drift_rad = 0.15;
  loop.warp.route_stretch_sigma = 0.03;
  loop.warp.bend_rad = 0.16;
  loop.warp.wave_m = 0.25;
  loop.warp.wave_length_m = 26.0;
  loop.warp.wobble_m = 0.03;
  loop.seed = 102;
  SlamRecipe bent;
  bent.warp = turned(-3.0, 4.0, 12.0);
  bent.warp.bend_rad = -0.24;
  bent.warp.route_stretch = -0.025;
  bent.warp.heading_drift_rad = 0.06;
  bent.warp.wave_m = 0.2;
  bent.warp.wave_length_m = 30.0;
  bent.warp.wobble_m = 0.04;
  bent.anchor_layout = AnchorLayout::kRandom;
  bent.sensor.range_max_m = 10.0;
  bent.sensor.people = 7;
  bent.seed = 203;
  site.slam_maps = {loop, bent};
  return site;
}

/// 80 x 40 m; the plan was plotted 4 % too small.
SampleSite corridorSite() {
  SampleSite site{"corridor", "INSTITUTE  SECOND FLOOR", {}, {}};
  site.building.plan.kind = SiteKind::kCorridor;
  site.building.plan.shape = CorridorShape::kU;
  site.building.plan.size_m = {80.0, 40.0};
  site.building.plan_scale = 1.04;
  site.building.resolution_m_per_px = 0.04;
  site.building.blueprint_origin = {0.0, -40.0};
  site.building.seed = 3;
  SlamRecipe drift;
  drift.warp = turned(5.0, 3.0, -95.0);
  drift.warp.heading_drift_rad = 0.2;
  drift.warp.route_stretch = -0.03;
  drift.warp.route_stretch_sigma = 0.02;
  drift.warp.correlation_m = 25.0;
  drift.warp.wobble_m = 0.04;
  drift.seed = 301;
  SlamRecipe short_corridor;
  short_corridor.warp = turned(60.0, 20.0, 31.0);
  short_corridor.warp.heading_drift_rad = 0.18;
  short_corridor.warp.route_stretch = 0.012;
  short_corridor.warp.route_stretch_sigma = 0.05;
  short_corridor.warp.bend_rad = 0.1;
  short_corridor.warp.wobble_m = 0.03;
  short_corridor.anchor_layout = AnchorLayout::kAlongRoute;
  short_corridor.seed = 402;
  site.slam_maps = {drift, short_corridor};
  return site;
}

/// 60 x 40 m; nothing is known of the plan's scale (it is 1.3 times too small).
SampleSite warehouseSite() {
  SampleSite site{"warehouse", "HALL C  RACKS", {}, {}};
  site.building.plan.kind = SiteKind::kHall;
  site.building.plan.size_m = {60.0, 40.0};
  site.building.plan_scale = 1.3;
  site.building.resolution_m_per_px = 0.03;
  site.building.blueprint_origin = {112.5, 48.0};
  site.building.seed = 5;
  SlamRecipe loops;
  loops.warp = turned(0.0, 0.0, 180.0);
  loops.warp.heading_drift_rad = 0.03;
  loops.warp.route_stretch_sigma = 0.008;
  loops.warp.correlation_m = 30.0;
  loops.warp.bend_rad = 0.26;
  loops.warp.wave_m = 0.4;
  loops.warp.wave_length_m = 35.0;
  loops.warp.wobble_m = 0.03;
  loops.sensor.range_max_m = 20.0;
  loops.seed = 501;
  SlamRecipe fields;
  fields.warp = turned(33.0, -8.0, 77.0);
  fields.warp.wave_m = 0.9;
  fields.warp.wave_length_m = 45.0;
  fields.warp.bend_rad = -0.22;
  fields.warp.wobble_m = 0.03;
  fields.sensor.range_max_m = 16.0;
  fields.anchor_layout = AnchorLayout::kRandom;
  fields.seed = 602;
  site.slam_maps = {loops, fields};
  return site;
}

/// A corner that is drawn in the SLAM map: occupied pixels at it and free ones beside it.
bool isVisible(const SlamMap& map, const Eigen::Vector2d& corner_in_slam) {
  const Eigen::Vector2d pixel = map.frame.pixelFromMetric(corner_in_slam);
  int occupied = 0;
  int free = 0;
  constexpr int kReach = 3;
  for (int dr = -kReach; dr <= kReach; ++dr) {
    for (int dc = -kReach; dc <= kReach; ++dc) {
      const int column = static_cast<int>(pixel.x()) + dc;
      const int row = static_cast<int>(pixel.y()) + dr;
      if (column < 0 || row < 0 || column >= map.picture.cols || row >= map.picture.rows) continue;
      const std::uint8_t value = map.picture.at<std::uint8_t>(row, column);
      occupied += value == 0 ? 1 : 0;
      free += value == 254 ? 1 : 0;
    }
  }
  return occupied >= 4 && free >= 6;
}

Result<void> makeSlamMap(const std::filesystem::path& folder, const SampleSite& site, const Building& building,
                         const SlamRecipe& recipe, const std::string& number) {
  SeededRandom random(recipe.seed);
  const std::vector<Eigen::Vector2d> places = freePlaces(building.plan, 1.0);
  const WarpField warp(recipe.warp, building.plan.route, building.plan.route_is_closed, places, random);
  const FurnishedWorld world = furnish(building.plan, random);
  const std::vector<Pose2> drive = driveThrough(building.plan, world, 0.25, random);
  const Result<SlamMap> map = mapDrive(building.plan, world, drive, warp, recipe.sensor, kSlamResolution, random);
  if (!map) return failAs(map);
  MapMetadata metadata;
  metadata.resolution_m_per_px = kSlamResolution;
  metadata.metric_from_corner = map->frame.metricFromCorner();
  const std::string image = "slam_" + number + ".png";
  if (Result<void> written = writeMap(folder / ("slam_" + number + ".yaml"), image, map->picture, metadata); !written) {
    return written;
  }
  AnchorRecipe anchors;
  anchors.count = recipe.anchor_count;
  anchors.layout = recipe.anchor_layout;
  anchors.blueprint_click_m = kClickPx * site.building.resolution_m_per_px;
  anchors.slam_click_m = kClickPx * kSlamResolution;
  AnchorList clicked = placeAnchors(building, warp, anchors, random, [&](const Eigen::Vector2d& corner) {
    return isVisible(*map, warp.slamFromPlan(corner));
  });
  for (Anchor& anchor : clicked) {  // to the millimetre, for readers
    anchor.in_blueprint = (anchor.in_blueprint * 1000.0).array().round() / 1000.0;
    anchor.in_slam = (anchor.in_slam * 1000.0).array().round() / 1000.0;
  }
  if (Result<void> written = writeAnchorsCsv(folder / ("anchors_" + number + ".csv"), clicked); !written) {
    return written;
  }
  const Result<TrueWarp> truth = sampleTrueWarp(building, warp);
  if (!truth) return failAs(truth);

  double least = 1e9;
  double most = 0.0;
  for (const Eigen::Vector2d& place : places) {
    const double area = warp.jacobian(place).determinant();
    least = std::min(least, area);
    most = std::max(most, area);
  }
  std::printf("%s slam_%s: %zu scans, %zu anchors, warp at %.0f %% strength, ratio of areas %.3f to %.3f\n",
              site.name.c_str(), number.c_str(), drive.size(), clicked.size(), 100.0 * warp.strength(), least, most);
  return writeTrueWarp(folder / ("truth_" + number + ".yaml"), *truth);
}

Result<void> makeSite(const std::filesystem::path& root, const SampleSite& site) {
  const Result<Building> building = makeBuilding(site.building);
  if (!building) return failAs(building);
  const std::filesystem::path folder = root / site.name;
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) return fail(ErrorCode::kUnwritable, "The folder cannot be made: " + error.message(), folder.string());
  MapMetadata metadata;
  metadata.resolution_m_per_px = building->blueprint.frame().resolution();
  metadata.metric_from_corner = building->blueprint.frame().metricFromCorner();
  if (Result<void> written =
          writeMap(folder / "blueprint.yaml", "blueprint.png", drawBlueprint(*building, site.title), metadata);
      !written) {
    return written;
  }
  for (std::size_t i = 0; i < site.slam_maps.size(); ++i) {
    if (Result<void> made = makeSlamMap(folder, site, *building, site.slam_maps[i], std::to_string(i + 1)); !made) {
      return made;
    }
  }
  return {};
}

}  // namespace
}  // namespace cad2slam::samples

int main(int argc, char** argv) {
  using namespace cad2slam::samples;
  const std::filesystem::path root = argc > 1 ? argv[1] : ".";
  const std::string wanted = argc > 2 ? argv[2] : "";
  for (const SampleSite& site : {officeSite(), corridorSite(), warehouseSite()}) {
    if (!wanted.empty() && wanted != site.name) continue;
    if (const cad2slam::Result<void> made = makeSite(root, site); !made) {
      std::fprintf(stderr, "%s\n", made.error().sentence().c_str());
      return 1;
    }
  }
  return 0;
}
