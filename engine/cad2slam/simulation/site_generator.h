// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <functional>

#include "cad2slam/anchors/anchor.h"
#include "cad2slam/core/result.h"
#include "cad2slam/map/occupancy_grid.h"
#include "cad2slam/simulation/site_plan.h"
#include "cad2slam/simulation/true_warp.h"
#include "cad2slam/simulation/warp_field.h"

namespace cad2slam {

/// A building and how its blueprint was drawn.
struct BuildingRecipe {
  SitePlanRecipe plan;
  double plan_scale = 1.0;                                     ///< metres of the building per metre of the blueprint
  double blueprint_turn_rad = 0.0;                             ///< of the building inside the blueprint
  Eigen::Vector2d blueprint_origin = Eigen::Vector2d::Zero();  ///< `origin:` of the blueprint [m]
  double resolution_m_per_px = 0.05;
  double margin_m = 1.5;  ///< around the building, in metres of the blueprint
  std::uint64_t seed = 1;
};

struct Building {
  SitePlan plan;
  Similarity2 blueprint_from_plan;
  OccupancyGrid blueprint;
};

enum class AnchorLayout {
  kSpread,      ///< evenly over the building, as the handbook says
  kRandom,      ///< any corners
  kClustered,   ///< in two or three groups, as when time is short
  kAlongRoute,  ///< beside the corridors only
};

struct AnchorRecipe {
  int count = 30;
  AnchorLayout layout = AnchorLayout::kSpread;
  double blueprint_click_m = 0.03;  ///< deviation of a click along each axis, in blueprint metres
  double slam_click_m = 0.06;       ///< the same in SLAM metres
  double as_built_m = 0.02;         ///< deviation of the real corner from the drawing
  int outliers = 0;                 ///< wrong pairs among the anchors
  double outlier_m = 8.0;           ///< how far those are off
};

/// Whether a corner of the building (plan frame [m]) can be seen in the SLAM map.
using CornerFilter = std::function<bool(const Eigen::Vector2d& corner_in_plan)>;

/// kOutOfDomain: sizes, scale or resolution that make no raster.
[[nodiscard]] Result<Building> makeBuilding(const BuildingRecipe& recipe);

/// Places inside the building at which a warp is checked, about `spacing_m` apart (plan frame [m]).
[[nodiscard]] std::vector<Eigen::Vector2d> freePlaces(const SitePlan& plan, double spacing_m);

/// What an installer would click. Fewer than asked for when the building has fewer corners.
[[nodiscard]] AnchorList placeAnchors(const Building& building, const WarpField& warp, const AnchorRecipe& recipe,
                                      SeededRandom& random, const CornerFilter& is_visible = {});

/// Samples the warp wherever the blueprint is free.
[[nodiscard]] Result<TrueWarp> sampleTrueWarp(const Building& building, const WarpField& warp, double step_m = 0.5);

/// Everything that defines one site with one SLAM map. The same recipe gives the same site.
struct SiteRecipe {
  BuildingRecipe building;
  WarpRecipe warp;
  AnchorRecipe anchors;
  std::uint64_t seed = 1;  ///< of warp and anchors
};

struct GeneratedSite {
  SiteRecipe recipe;
  Building building;
  WarpField warp;
  AnchorList anchors;

  [[nodiscard]] Pose2 slamFromBlueprint(const Pose2& pose_in_blueprint) const;
};

/// A random recipe: flats, offices, corridors and halls of 8 to 120 m, plans to scale and not, all kinds of warps,
/// numbers and layouts of anchors, rasters of about half a million pixels at most.
[[nodiscard]] SiteRecipe randomSiteRecipe(std::uint64_t seed);

[[nodiscard]] Result<GeneratedSite> generateSite(const SiteRecipe& recipe);

}  // namespace cad2slam
