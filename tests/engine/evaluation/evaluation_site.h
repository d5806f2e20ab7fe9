// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "cad2slam/mesh/mesh_builder.h"
#include "cad2slam/simulation/site_generator.h"

namespace cad2slam::test {

/// A small generated site with a coarse mesh: quick to solve many times.
struct EvaluationSite {
  GeneratedSite site;
  std::shared_ptr<const Mesh> mesh;
};

inline EvaluationSite makeEvaluationSite(const WarpRecipe& warp, int anchors, double click_m = 0.02) {
  SiteRecipe recipe;
  recipe.building.plan = {SiteKind::kOffice, {30.0, 14.0}, CorridorShape::kU};
  recipe.building.resolution_m_per_px = 0.1;
  recipe.warp = warp;
  recipe.anchors = {anchors, AnchorLayout::kSpread, click_m, click_m, 0.0, 0, 0.0};
  GeneratedSite site = generateSite(recipe).value();
  auto mesh = std::make_shared<const Mesh>(buildMesh(site.building.blueprint, 1.5).value());
  return {std::move(site), std::move(mesh)};
}

inline WarpRecipe rigidWarp() {
  WarpRecipe warp;
  warp.slam_from_plan = {{12.0, -3.0}, 2.0};
  return warp;
}

inline WarpRecipe bentWarp() {
  WarpRecipe warp = rigidWarp();
  warp.bend_rad = 0.3;
  warp.route_stretch = -0.04;
  return warp;
}

}  // namespace cad2slam::test
