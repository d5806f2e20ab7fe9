// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/exports/similarity_export.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace cad2slam {
namespace {

using Eigen::Vector2d;

struct Place {
  Vector2d in_blueprint;
  std::string name;
};

constexpr std::size_t kMostPlaces = 10'000'000;

Result<std::vector<Place>> placesOf(const FeatureList& features, double spacing_m) {
  std::vector<Place> places;
  for (const Feature& feature : features) {
    for (const PointList& part : feature.parts) {
      for (std::size_t k = 0; k < part.size(); ++k) {
        if (k > 0 && feature.kind == FeatureKind::kPath) {
          const double pieces = std::ceil((part[k] - part[k - 1]).norm() / spacing_m);
          if (!(pieces + static_cast<double>(places.size()) < static_cast<double>(kMostPlaces))) {
            return fail(ErrorCode::kOutOfDomain, "the paths are too long for this spacing", feature.name);
          }
          for (double piece = 1.0; piece < pieces; ++piece) {
            places.push_back({part[k - 1] + piece / pieces * (part[k] - part[k - 1]), feature.name});
          }
        }
        places.push_back({part[k], feature.name});
      }
    }
  }
  return places;
}

}  // namespace

Result<LevelTransform> fitLevelTransform(const Projector& projector, const FeatureList& features, double spacing_m,
                                         std::size_t reference_count) {
  if (!(spacing_m > 0.0) || reference_count < 2) {
    return fail(ErrorCode::kOutOfDomain, "a fit needs a spacing above 0 m and at least two references");
  }
  Result<std::vector<Place>> places = placesOf(features, spacing_m);
  if (!places) return failAs(places);
  if (features.empty()) {
    for (const Vector2d& middle : projector.tileMiddles()) places->push_back({middle, ""});
  }
  std::vector<PointPair> pairs;
  pairs.reserve(places->size());
  for (const Place& place : *places) {
    const Projection found = projector.slamFromBlueprint({place.in_blueprint, 0.0});
    if (!found.ok()) {
      if (features.empty()) continue;  // a tile that folds
      return fail(ErrorCode::kOutOfDomain,
                  "the place (" + std::to_string(place.in_blueprint.x()) + ", " +
                      std::to_string(place.in_blueprint.y()) + ") has no image in the SLAM map",
                  place.name);
    }
    pairs.push_back({place.in_blueprint, found.pose.translation});
  }
  const Result<Similarity2> fit = fitSimilarity(pairs, std::nullopt);
  if (!fit) return failAs(fit);

  LevelTransform transform;
  transform.slam_from_blueprint = *fit;
  transform.places = pairs.size();
  transform.rms_m = rmsResidual(*fit, pairs);
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const double residual = (pairs[k].target - *fit * pairs[k].source).norm();
    if (residual < transform.max_m) continue;
    transform.max_m = residual;
    transform.worst_in_blueprint = pairs[k].source;
    transform.worst_name = places->size() == pairs.size() ? (*places)[k].name : "";
  }
  const std::size_t count = std::min(reference_count, pairs.size());
  for (std::size_t k = 0; k < count; ++k)
    transform.references.push_back(pairs[(2 * k + 1) * pairs.size() / (2 * count)]);
  return transform;
}

}  // namespace cad2slam
