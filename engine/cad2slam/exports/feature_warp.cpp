// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/exports/feature_warp.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>
#include <optional>
#include <string>
#include <utility>

#include "cad2slam/geometry/pose2.h"

namespace cad2slam {
namespace {

using Eigen::Vector2d;

constexpr std::size_t kMostSamplesPerEdge = 1'000'000;

/// For messages; a plain number in every locale.
std::string textOf(double number) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, number, std::chars_format::general, 7).ptr};
}

double distanceToChord(const Vector2d& place, const Vector2d& from, const Vector2d& to) {
  const Vector2d along = to - from;
  const double squared = along.squaredNorm();
  const double part = squared > 0.0 ? std::clamp((place - from).dot(along) / squared, 0.0, 1.0) : 0.0;
  return (place - (from + part * along)).norm();
}

/// Marks the vertices of a polyline that must stay so that the others lie within `tolerance` of the chords (Douglas
/// and Peucker); the first and the last stay.
std::vector<bool> neededVertices(const PointList& line, double tolerance) {
  std::vector<bool> needed(line.size(), false);
  needed.front() = needed.back() = true;
  std::vector<std::pair<std::size_t, std::size_t>> open = {{0, line.size() - 1}};
  while (!open.empty()) {
    const auto [first, last] = open.back();
    open.pop_back();
    double farthest = tolerance;
    std::size_t worst = first;
    for (std::size_t k = first + 1; k < last; ++k) {
      const double distance = distanceToChord(line[k], line[first], line[last]);
      if (distance <= farthest) continue;
      farthest = distance;
      worst = k;
    }
    if (worst == first) continue;
    needed[worst] = true;
    open.emplace_back(first, worst);
    open.emplace_back(worst, last);
  }
  return needed;
}

class EdgeWarper {
 public:
  EdgeWarper(const Projector& projector, const FeatureWarpOptions& options) : projector_(projector), options_(options) {
    // Within a quarter of a tile the function is next to a parabola; halves of the tolerance are kept for that.
    const double cell = projector.info().lattice.cell_size;
    step_m_ = 0.25 * (options.direction == WarpDirection::kToSlam ? cell : cell * projector.info().scale);
  }

  [[nodiscard]] Result<Pose2> pose(const Pose2& place) const {
    const Projection found = options_.direction == WarpDirection::kToSlam
                                 ? projector_.slamFromBlueprint(place, options_.outside)
                                 : projector_.blueprintFromSlam(place, options_.outside);
    if (found.ok()) return found.pose;
    const char* why = found.status == ProjectionStatus::kFolded ? "lies where the mesh folds"
                      : found.status == ProjectionStatus::kInvalid
                          ? "is not finite"
                          : "lies outside the mesh; with 'outside rigid' it would continue there";
    return fail(ErrorCode::kOutOfDomain,
                "the place (" + textOf(place.translation.x()) + ", " + textOf(place.translation.y()) + ") " + why);
  }

  /// Appends the image of an edge without its first vertex.
  [[nodiscard]] Result<void> appendEdge(const Vector2d& from, const Vector2d& to, PointList& out) {
    const double pieces = std::max(1.0, std::ceil((to - from).norm() / step_m_));
    if (!(pieces < static_cast<double>(kMostSamplesPerEdge))) {
      return fail(ErrorCode::kOutOfDomain, "an edge is too long for a building");
    }
    const auto count = static_cast<std::size_t>(pieces);
    PointList samples = {out.back()};
    for (std::size_t k = 1; k <= count; ++k) {
      const double part = static_cast<double>(k) / static_cast<double>(count);
      const Vector2d before = from + (static_cast<double>(k - 1) / static_cast<double>(count)) * (to - from);
      if (Result<void> added = appendPiece(before, from + part * (to - from), samples, kDeepest); !added) return added;
    }
    for (const Vector2d& sample : samples) {
      largest_sagitta_m_ = std::max(largest_sagitta_m_, distanceToChord(sample, samples.front(), samples.back()));
    }
    const std::vector<bool> needed = neededVertices(samples, 0.5 * options_.chord_error_m);
    for (std::size_t k = 1; k < samples.size(); ++k) {
      if (needed[k]) out.push_back(samples[k]);
    }
    return {};
  }

  [[nodiscard]] double largestSagitta() const { return largest_sagitta_m_; }

 private:
  static constexpr int kDeepest = 12;

  /// Halves a piece until its middle lies within a quarter of the tolerance of the chord.
  [[nodiscard]] Result<void> appendPiece(const Vector2d& from, const Vector2d& to, PointList& samples, int depth) {
    const Result<Pose2> end = pose({to, 0.0});
    if (!end) return failAs(end);
    const Vector2d middle = 0.5 * (from + to);
    const Result<Pose2> half = pose({middle, 0.0});
    if (!half) return failAs(half);
    const bool straight =
        distanceToChord(half->translation, samples.back(), end->translation) <= 0.25 * options_.chord_error_m;
    if (straight || depth == 0) {
      samples.push_back(end->translation);
      return {};
    }
    if (Result<void> first = appendPiece(from, middle, samples, depth - 1); !first) return first;
    return appendPiece(middle, to, samples, depth - 1);
  }

  const Projector& projector_;
  const FeatureWarpOptions& options_;
  double step_m_ = 1.0;
  double largest_sagitta_m_ = 0.0;
};

Result<PointList> warpPart(EdgeWarper& warper, const PointList& part, bool closed) {
  const Result<Pose2> start = warper.pose({part.front(), 0.0});
  if (!start) return failAs(start);
  PointList warped = {start->translation};
  for (std::size_t k = 1; k < part.size() + (closed ? 1 : 0); ++k) {
    const Result<void> added = warper.appendEdge(part[k - 1], part[k % part.size()], warped);
    if (!added) return failAs(added);
  }
  if (closed) warped.pop_back();
  return warped;
}

Result<Feature> warpFeature(EdgeWarper& warper, const Feature& feature) {
  Feature warped = feature;
  for (PointList& part : warped.parts) {
    if (part.empty()) return fail(ErrorCode::kMalformed, "has a part without a place");
    if (feature.kind == FeatureKind::kPoint) {
      const Result<Pose2> pose = warper.pose({part.front(), feature.heading.value_or(0.0)});
      if (!pose) return failAs(pose);
      part = {pose->translation};
      if (feature.heading) warped.heading = pose->heading;
      continue;
    }
    Result<PointList> line = warpPart(warper, part, feature.kind == FeatureKind::kPolygon);
    if (!line) return failAs(line);
    part = std::move(*line);
  }
  return warped;
}

std::size_t vertexCount(const Feature& feature) {
  return std::accumulate(feature.parts.begin(), feature.parts.end(), std::size_t{0},
                         [](std::size_t sum, const PointList& part) { return sum + part.size(); });
}

double cross(const Vector2d& a, const Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

bool onSegment(const Vector2d& place, const Vector2d& from, const Vector2d& to) {
  return (place.array() >= from.cwiseMin(to).array()).all() && (place.array() <= from.cwiseMax(to).array()).all();
}

bool segmentsTouch(const Vector2d& a, const Vector2d& b, const Vector2d& c, const Vector2d& d) {
  const auto side = [](double value) { return value > 0.0 ? 1 : value < 0.0 ? -1 : 0; };
  const int c_side = side(cross(b - a, c - a));
  const int d_side = side(cross(b - a, d - a));
  const int a_side = side(cross(d - c, a - c));
  const int b_side = side(cross(d - c, b - c));
  if (c_side != d_side && a_side != b_side && c_side * d_side <= 0 && a_side * b_side <= 0) return true;
  return (c_side == 0 && onSegment(c, a, b)) || (d_side == 0 && onSegment(d, a, b)) ||
         (a_side == 0 && onSegment(a, c, d)) || (b_side == 0 && onSegment(b, c, d));
}

}  // namespace

bool crossesItself(const PointList& ring) {
  const std::size_t n = ring.size();
  if (n < 4) return false;
  // Edges in order of their left ends: only those that overlap in x can touch.
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto left = [&](std::size_t k) { return std::min(ring[k].x(), ring[(k + 1) % n].x()); };
  const auto right = [&](std::size_t k) { return std::max(ring[k].x(), ring[(k + 1) % n].x()); };
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return left(a) < left(b); });
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t a = order[i];
    for (std::size_t j = i + 1; j < n && left(order[j]) <= right(a); ++j) {
      const std::size_t b = order[j];
      const bool neighbours = (a + 1) % n == b || (b + 1) % n == a;
      if (!neighbours && segmentsTouch(ring[a], ring[(a + 1) % n], ring[b], ring[(b + 1) % n])) return true;
    }
  }
  return false;
}

Result<WarpedFeatures> warpFeatures(const Projector& projector, const FeatureList& features,
                                    const FeatureWarpOptions& options) {
  if (!(options.chord_error_m > 0.0)) return fail(ErrorCode::kOutOfDomain, "the chord error must be above 0 m");
  WarpedFeatures warped;
  EdgeWarper warper(projector, options);
  for (std::size_t k = 0; k < features.size(); ++k) {
    Result<Feature> feature = warpFeature(warper, features[k]);
    if (!feature) return fail(feature.error().code, feature.error().message, titleOf(features[k], k));
    if (feature->kind == FeatureKind::kPolygon) {
      for (std::size_t part = 0; part < feature->parts.size(); ++part) {
        if (crossesItself(feature->parts[part]) && !crossesItself(features[k].parts[part])) {
          warped.warnings.push_back(titleOf(features[k], k) + " crosses itself after warping");
        }
      }
    }
    warped.vertices_before += vertexCount(features[k]);
    warped.vertices_after += vertexCount(*feature);
    warped.features.push_back(std::move(*feature));
  }
  warped.largest_sagitta_m = warper.largestSagitta();
  return warped;
}

}  // namespace cad2slam
