// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/io/rmf_building.h"

#include "cad2slam/io/atomic_file.h"
#include "cad2slam/io/guarded_yaml.h"
#include "cad2slam/io/text.h"

#include <optional>
#include <set>
#include <utility>

namespace cad2slam {
namespace {

constexpr std::size_t kLargestText = std::size_t{1} << 26;

[[noreturn]] void refuse(const YAML::Node& node, const std::string& message) {
  throw YamlRefusal{node.Mark().line + 1, message};
}

std::string textOf(const YAML::Node& node) {
  return node.IsDefined() && node.IsScalar() ? node.Scalar() : std::string();
}

double numberOf(const YAML::Node& node, const char* what) {
  const std::optional<double> number = parseNumber(textOf(node));
  if (!number) refuse(node, std::string(what) + " must be a finite number");
  return *number;
}

/// Children of a map or list; none where it is missing.
YAML::Node listOf(const YAML::Node& parent, const char* key) {
  const YAML::Node node = parent[key];
  if (node.IsDefined() && !node.IsNull() && !node.IsSequence()) refuse(node, std::string(key) + " must be a list");
  return node.IsDefined() && node.IsSequence() ? node : YAML::Node(YAML::NodeType::Sequence);
}

YAML::Node mapOf(const YAML::Node& parent, const char* key) {
  const YAML::Node node = parent[key];
  if (node.IsDefined() && !node.IsNull() && !node.IsMap()) refuse(node, std::string(key) + " must be a map");
  return node.IsDefined() && node.IsMap() ? node : YAML::Node(YAML::NodeType::Map);
}

std::map<std::string, RmfMark> marksOf(const YAML::Node& parent) {
  std::map<std::string, RmfMark> marks;
  for (const YAML::Node& item : listOf(parent, "features")) {
    if (!item.IsMap()) refuse(item, "a feature must be a map");
    const std::string id = textOf(item["id"]);
    if (id.empty()) refuse(item, "a feature has no id");
    const RmfMark mark{{numberOf(item["x"], "x"), numberOf(item["y"], "y")}, textOf(item["name"])};
    if (!marks.emplace(id, mark).second) refuse(item, "the id " + excerpt(id) + " stands twice");
  }
  return marks;
}

RmfLevel levelOf(const YAML::Node& node) {
  RmfLevel level;
  level.picture = textOf(mapOf(node, "drawing")["filename"]);
  level.marks = marksOf(node);
  for (const auto& entry : mapOf(node, "layers")) {
    if (!entry.second.IsMap()) refuse(entry.second, "a layer must be a map");
    level.layers[textOf(entry.first)] = {textOf(entry.second["filename"]), marksOf(entry.second)};
  }
  for (const YAML::Node& item : listOf(node, "constraints")) {
    const YAML::Node ids = item.IsMap() ? listOf(item, "ids") : YAML::Node();
    if (ids.size() != 2) refuse(item, "a constraint must have two ids");
    level.constraints.push_back({textOf(ids[0]), textOf(ids[1])});
  }
  for (const YAML::Node& item : listOf(node, "vertices")) {
    if (!item.IsSequence() || item.size() < 2) refuse(item, "a vertex must be a list of x and y");
    RmfMark vertex{{numberOf(item[0], "x"), numberOf(item[1], "y")}, {}};
    if (item.size() > 3) vertex.name = textOf(item[3]);
    level.vertices.push_back(std::move(vertex));
  }
  for (const YAML::Node& item : listOf(node, "lanes")) {
    if (!item.IsSequence() || item.size() < 2) refuse(item, "a lane must be a list of two vertices");
    const std::optional<std::size_t> from = parseInteger<std::size_t>(textOf(item[0]));
    const std::optional<std::size_t> to = parseInteger<std::size_t>(textOf(item[1]));
    if (!from || !to) refuse(item, "a lane must name two vertices by number");
    if (*from < level.vertices.size() && *to < level.vertices.size()) level.lanes.push_back({*from, *to});
  }
  return level;
}

template <class Map>
std::string namesOf(const Map& map) {
  std::string names;
  for (const auto& entry : map) names += (names.empty() ? "" : ", ") + excerpt(entry.first);
  return names.empty() ? "none" : names;
}

bool isInside(const MapFrame& frame, const Eigen::Vector2d& pixel) {
  return pixel.x() >= 0.0 && pixel.y() >= 0.0 && pixel.x() <= frame.width() && pixel.y() <= frame.height();
}

}  // namespace

Result<RmfBuilding> parseRmfBuilding(const std::string& text, const std::string& file_name) {
  const auto malformed = [&](int line, const std::string& message) {
    return fail(ErrorCode::kMalformed, message, file_name + ":" + std::to_string(line));
  };
  const Result<YAML::Node> loaded = loadYaml(text, file_name);
  if (!loaded) return failAs(loaded);
  try {
    const YAML::Node& root = *loaded;
    if (!root.IsMap() || !root["levels"].IsDefined()) {
      return fail(ErrorCode::kMalformed, "is no building of the traffic editor: it has no levels", file_name);
    }
    RmfBuilding building;
    for (const auto& entry : mapOf(root, "levels")) {
      if (!entry.second.IsMap()) refuse(entry.second, "a level must be a map");
      building.levels[textOf(entry.first)] = levelOf(entry.second);
    }
    return building;
  } catch (const YamlRefusal& refusal) {
    return malformed(refusal.line, refusal.message);
  } catch (const YAML::Exception& error) {
    return malformed(error.mark.line + 1, "is not valid YAML (" + error.msg + ")");
  }
}

Result<RmfBuilding> readRmfBuilding(const std::filesystem::path& path) {
  const Result<std::string> text = readFile(path, kLargestText);
  if (!text) return failAs(text);
  return parseRmfBuilding(*text, path.string());
}

Result<RmfLevel> findLevel(const RmfBuilding& building, const std::string& name) {
  if (name.empty() && building.levels.size() == 1) return building.levels.begin()->second;
  const auto place = building.levels.find(name);
  if (place != building.levels.end()) return place->second;
  return fail(ErrorCode::kNotFound, (name.empty() ? "say which level is meant" : "there is no level " + excerpt(name)) +
                                        std::string("; the building has ") + namesOf(building.levels));
}

Result<AnchorList> anchorsOf(const RmfLevel& level, const std::string& layer, const MapFrame& blueprint,
                             const MapFrame& slam) {
  const auto place = layer.empty() && level.layers.size() == 1 ? level.layers.begin() : level.layers.find(layer);
  if (place == level.layers.end()) {
    return fail(ErrorCode::kNotFound,
                (layer.empty() ? "say which layer is meant" : "there is no layer " + excerpt(layer)) +
                    std::string("; the level has ") + namesOf(level.layers));
  }
  AnchorList anchors;
  std::set<std::array<std::string, 2>> seen;
  for (std::array<std::string, 2> ids : level.constraints) {
    if (level.marks.count(ids[0]) == 0) std::swap(ids[0], ids[1]);
    const auto on_blueprint = level.marks.find(ids[0]);
    const auto on_layer = place->second.marks.find(ids[1]);
    if (on_blueprint == level.marks.end() || on_layer == place->second.marks.end()) continue;  // of another layer
    if (!seen.insert(ids).second) continue;
    const RmfMark& in_blueprint = on_blueprint->second;
    const RmfMark& in_slam = on_layer->second;
    if (!isInside(blueprint, in_blueprint.pixel) || !isInside(slam, in_slam.pixel)) {
      return fail(ErrorCode::kOutOfDomain, "the mark " + excerpt(isInside(slam, in_slam.pixel) ? ids[0] : ids[1]) +
                                               " lies outside its picture: is the map the one of the building file (" +
                                               level.picture + ", " + place->second.picture + ")?");
    }
    Anchor anchor;
    anchor.id = static_cast<AnchorId>(anchors.size() + 1);
    anchor.in_blueprint = blueprint.metricFromPixel(in_blueprint.pixel);
    anchor.in_slam = slam.metricFromPixel(in_slam.pixel);
    anchor.name = in_blueprint.name.empty() ? in_slam.name : in_blueprint.name;
    anchors.push_back(std::move(anchor));
  }
  if (anchors.empty()) {
    return fail(ErrorCode::kNotFound,
                "no constraint joins a mark of the drawing with one of layer " + excerpt(place->first));
  }
  return anchors;
}

FeatureList lanesOf(const RmfLevel& level, const MapFrame& blueprint) {
  FeatureList features;
  for (const auto& [from, to] : level.lanes) {
    Feature lane;
    lane.kind = FeatureKind::kPath;
    lane.parts = {
        {blueprint.metricFromPixel(level.vertices[from].pixel), blueprint.metricFromPixel(level.vertices[to].pixel)}};
    lane.name = "lane " + std::to_string(from) + " to " + std::to_string(to);
    features.push_back(std::move(lane));
  }
  for (const RmfMark& vertex : level.vertices) {
    if (vertex.name.empty()) continue;
    Feature point;
    point.parts = {{blueprint.metricFromPixel(vertex.pixel)}};
    point.name = vertex.name;
    features.push_back(std::move(point));
  }
  return features;
}

}  // namespace cad2slam
