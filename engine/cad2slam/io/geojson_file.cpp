// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/io/geojson_file.h"

#include "cad2slam/io/atomic_file.h"
#include "cad2slam/io/json_reader.h"
#include "cad2slam/io/strict_json.h"
#include "cad2slam/io/text.h"

#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace cad2slam {
namespace {

using nlohmann::json;

constexpr std::size_t kLargestText = std::size_t{1} << 28;
constexpr std::array<const char*, 3> kHeadingKeys = {"heading_rad", "theta", "yaw"};

Eigen::Vector2d readPlace(const JsonReader& place) {
  if (place.size() < 2) {
    place.report("must be a list of x and y");
    return Eigen::Vector2d::Zero();
  }
  return {place.at(0).number(0.0), place.at(1).number(0.0)};
}

PointList readPlaces(const JsonReader& list, std::size_t least) {
  PointList places;
  for (std::size_t k = 0; k < list.size(); ++k) places.push_back(readPlace(list.at(k)));
  if (places.size() < least) list.report("must have at least " + std::to_string(least) + " places");
  return places;
}

/// Rings are closed in the file and open in memory.
PointList readRing(const JsonReader& list) {
  PointList ring = readPlaces(list, 3);
  while (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
  if (ring.size() < 3) list.report("must go around an area");
  return ring;
}

void readPolygon(const JsonReader& rings, Feature& feature) {
  if (rings.size() == 0) rings.report("must have a ring");
  for (std::size_t k = 0; k < rings.size(); ++k) feature.parts.push_back(readRing(rings.at(k)));
  feature.rings_of_polygon.push_back(rings.size());
}

void readGeometry(const JsonReader& geometry, Feature& feature) {
  const std::string type = geometry["type"].required().text();
  const JsonReader coordinates = geometry["coordinates"].required();
  feature.multiple = type.rfind("Multi", 0) == 0;
  if (feature.multiple && coordinates.size() == 0) coordinates.report("must not be empty");
  const std::size_t count = feature.multiple ? coordinates.size() : 1;
  for (std::size_t k = 0; k < count; ++k) {
    const JsonReader part = feature.multiple ? coordinates.at(k) : coordinates;
    if (type == "Point" || type == "MultiPoint") {
      feature.kind = FeatureKind::kPoint;
      feature.parts.push_back({readPlace(part)});
    } else if (type == "LineString" || type == "MultiLineString") {
      feature.kind = FeatureKind::kPath;
      feature.parts.push_back(readPlaces(part, 2));
    } else if (type == "Polygon" || type == "MultiPolygon") {
      feature.kind = FeatureKind::kPolygon;
      readPolygon(part, feature);
    } else {
      return geometry["type"].report("is " + excerpt(type) + ", which is none of the known geometries");
    }
  }
}

Feature readFeature(const JsonReader& item) {
  Feature feature;
  const JsonReader geometry = item["geometry"].required();
  if (geometry.exists()) readGeometry(geometry, feature);
  const JsonReader properties = item["properties"];
  if (!properties.isNull()) {
    if (properties["name"].exists() && properties["name"].value().is_string()) {
      feature.name = properties["name"].text();
    }
    for (const char* key : kHeadingKeys) {
      const JsonReader heading = properties[key];
      if (heading.exists() && feature.kind == FeatureKind::kPoint) feature.heading = heading.number(0.0);
    }
    if (properties.value().is_object()) feature.properties = properties.value().dump();
  }
  if (item["id"].exists()) feature.id = item["id"].value().dump();
  return feature;
}

json coordinatesOf(const Eigen::Vector2d& place) {
  return json::array({place.x(), place.y()});
}

json coordinatesOf(const PointList& places, bool closed) {
  json list = json::array();
  for (const Eigen::Vector2d& place : places) list.push_back(coordinatesOf(place));
  if (closed && !places.empty()) list.push_back(coordinatesOf(places.front()));
  return list;
}

json geometryOf(const Feature& feature) {
  const std::string prefix = feature.multiple ? "Multi" : "";
  json list = json::array();
  if (feature.kind == FeatureKind::kPoint) {
    for (const PointList& part : feature.parts) list.push_back(coordinatesOf(part.front()));
    return {{"type", prefix + "Point"}, {"coordinates", feature.multiple ? list : list.front()}};
  }
  if (feature.kind == FeatureKind::kPath) {
    for (const PointList& part : feature.parts) list.push_back(coordinatesOf(part, false));
    return {{"type", prefix + "LineString"}, {"coordinates", feature.multiple ? list : list.front()}};
  }
  std::vector<std::size_t> counts = feature.rings_of_polygon;
  if (counts.empty()) counts.push_back(feature.parts.size());
  std::size_t ring = 0;
  for (const std::size_t count : counts) {
    json rings = json::array();
    for (std::size_t k = 0; k < count && ring < feature.parts.size(); ++k) {
      rings.push_back(coordinatesOf(feature.parts[ring++], true));
    }
    list.push_back(std::move(rings));
  }
  return {{"type", prefix + "Polygon"}, {"coordinates", feature.multiple ? list : list.front()}};
}

}  // namespace

Result<FeatureList> parseGeoJson(std::string_view text, const std::string& file_name) {
  const Result<json> document = parseStrictJson(text, file_name);
  if (!document) return failAs(document);
  JsonProblem problem(file_name);
  const JsonReader root(&*document, "", problem);
  const std::string type = root["type"].required().text();
  FeatureList features;
  if (type == "FeatureCollection") {
    const JsonReader items = root["features"].required();
    for (std::size_t k = 0; k < items.size() && !problem.error(); ++k) features.push_back(readFeature(items.at(k)));
  } else if (type == "Feature") {
    features.push_back(readFeature(root));
  } else if (root["type"].exists()) {
    Feature feature;
    readGeometry(root, feature);
    features.push_back(std::move(feature));
  }
  if (problem.error()) return tl::unexpected(*problem.error());
  return features;
}

Result<FeatureList> readGeoJson(const std::filesystem::path& path) {
  const Result<std::string> text = readFile(path, kLargestText);
  if (!text) return failAs(text);
  return parseGeoJson(*text, path.string());
}

Result<std::string> formatGeoJson(const FeatureList& features, const std::string& frame) {
  // One feature a line: such files are compared and kept under version control.
  std::string text = "{\"type\": \"FeatureCollection\", \"features\": [";
  for (std::size_t k = 0; k < features.size(); ++k) {
    const Feature& feature = features[k];
    Result<json> properties = parseStrictJson(feature.properties, titleOf(feature, k));
    if (!properties) return failAs(properties);
    if (!properties->is_object())
      return fail(ErrorCode::kMalformed, "its properties are no object", titleOf(feature, k));
    if (!feature.name.empty()) (*properties)["name"] = feature.name;
    if (feature.heading) {
      const char* key = kHeadingKeys.front();
      for (const char* candidate : kHeadingKeys) {
        if (properties->contains(candidate)) key = candidate;
      }
      (*properties)[key] = *feature.heading;
    }
    (*properties)["frame"] = frame;
    json item = {{"type", "Feature"}, {"geometry", geometryOf(feature)}, {"properties", std::move(*properties)}};
    if (!feature.id.empty()) {
      Result<json> id = parseStrictJson(feature.id, titleOf(feature, k));
      if (!id) return failAs(id);
      item["id"] = std::move(*id);
    }
    text += (k == 0 ? "\n" : ",\n") + item.dump(-1, ' ', false, json::error_handler_t::replace);
  }
  return text + "\n]}\n";
}

}  // namespace cad2slam
