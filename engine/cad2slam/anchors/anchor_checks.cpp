// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/anchors/anchor_checks.h"

#include <algorithm>
#include <cstdio>
#include <string>
#include <unordered_set>

namespace cad2slam {
namespace {

/// Two anchors this near in one map [m] are meant to be the same place there.
constexpr double kSamePlace_m = 1e-3;
/// ... and then may differ this much in the other map [m]: more is not click noise.
constexpr double kMayDiffer_m = 0.5;

std::string metres(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f m", value);
  return text;
}

std::string nameOf(const Anchor& anchor) {
  return "anchor " + std::to_string(anchor.id);
}

/// How far a point lies outside the raster [m]; 0 inside.
double outsideBy(const MapFrame& frame, const Eigen::Vector2d& point_m) {
  const Eigen::Vector2d pixel = frame.pixelFromMetric(point_m);
  const Eigen::Vector2d size(frame.width(), frame.height());
  return (pixel - pixel.cwiseMax(0.0).cwiseMin(size)).norm() * frame.resolution();
}

Result<void> checkInside(const Anchor& anchor, const std::optional<MapFrame>& frame, const Eigen::Vector2d& point_m,
                         const char* map_name) {
  if (!frame) return {};
  const double outside_m = outsideBy(*frame, point_m);
  if (outside_m <= 0.1 * frame->diagonal()) return {};
  return fail(
      ErrorCode::kOutOfDomain,
      std::string("its point lies ") + metres(outside_m) + " outside the " + map_name + "; correct or disable it",
      nameOf(anchor));
}

/// Sorted by x, only neighbours within the tolerance have to be compared.
Result<void> checkContradictions(const AnchorList& anchors, Eigen::Vector2d Anchor::*here,
                                 Eigen::Vector2d Anchor::*there, const char* here_name, const char* there_name) {
  std::vector<const Anchor*> sorted;
  for (const Anchor& anchor : anchors) {
    if (anchor.enabled) sorted.push_back(&anchor);
  }
  std::stable_sort(sorted.begin(), sorted.end(),
                   [here](const Anchor* a, const Anchor* b) { return (a->*here).x() < (b->*here).x(); });
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    for (std::size_t j = i + 1; j < sorted.size(); ++j) {
      if ((sorted[j]->*here).x() - (sorted[i]->*here).x() > kSamePlace_m) break;
      if ((sorted[j]->*here - sorted[i]->*here).norm() > kSamePlace_m) continue;
      const double apart_m = (sorted[j]->*there - sorted[i]->*there).norm();
      if (apart_m <= kMayDiffer_m) continue;
      const auto [first, second] = std::minmax(sorted[i]->id, sorted[j]->id);
      return fail(ErrorCode::kDegenerate, "anchors " + std::to_string(first) + " and " + std::to_string(second) +
                                              " share a " + here_name + " point but are " + metres(apart_m) +
                                              " apart in the " + there_name + "; correct or disable one of them");
    }
  }
  return {};
}

}  // namespace

Result<void> checkAnchors(const AnchorList& anchors, const AnchorFrames& frames) {
  std::unordered_set<AnchorId> ids;
  for (const Anchor& anchor : anchors) {
    if (!ids.insert(anchor.id).second) {
      return fail(ErrorCode::kMalformed, "its number is used twice", nameOf(anchor));
    }
    if (!anchor.in_blueprint.allFinite() || !anchor.in_slam.allFinite()) {
      return fail(ErrorCode::kMalformed, "its coordinates are not finite numbers", nameOf(anchor));
    }
    if (!anchor.enabled) continue;
    if (auto inside = checkInside(anchor, frames.blueprint, anchor.in_blueprint, "blueprint"); !inside) return inside;
    if (auto inside = checkInside(anchor, frames.slam, anchor.in_slam, "SLAM map"); !inside) return inside;
  }
  if (auto agree = checkContradictions(anchors, &Anchor::in_blueprint, &Anchor::in_slam, "blueprint", "SLAM map");
      !agree) {
    return agree;
  }
  return checkContradictions(anchors, &Anchor::in_slam, &Anchor::in_blueprint, "SLAM map", "blueprint");
}

}  // namespace cad2slam
