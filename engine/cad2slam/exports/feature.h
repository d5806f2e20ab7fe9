// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

namespace cad2slam {

/// Places that belong together: all points of a multi-point, the vertices of a path, one ring of a polygon.
using PointList = std::vector<Eigen::Vector2d>;

enum class FeatureKind {
  kPoint,    ///< `parts[k]` holds one point
  kPath,     ///< `parts[k]` is an open line of at least two vertices
  kPolygon,  ///< `parts[k]` is a ring of at least three vertices, the first not repeated at the end
};

/// Something drawn on a map: a place, a path or a zone. Metres, in the frame of that map.
struct Feature {
  FeatureKind kind = FeatureKind::kPoint;
  /// With kPolygon all rings of all polygons; a place is inside where an odd number of rings goes around it.
  std::vector<PointList> parts;
  /// With kPolygon: how many rings each polygon has, its outer one first. Empty means one polygon.
  std::vector<std::size_t> rings_of_polygon;
  bool multiple = false;          ///< written as a Multi... geometry
  std::optional<double> heading;  ///< [rad], of a point
  std::string name;
  /// Everything else that is known of it, as the text of a JSON object, kept as it is.
  std::string properties = "{}";
  std::string id;  ///< as the text of a JSON value, or empty
};

using FeatureList = std::vector<Feature>;

/// How to call a feature in a message: its name or its number.
inline std::string titleOf(const Feature& feature, std::size_t index) {
  return feature.name.empty() ? "feature " + std::to_string(index + 1) : "'" + feature.name + "'";
}

}  // namespace cad2slam
