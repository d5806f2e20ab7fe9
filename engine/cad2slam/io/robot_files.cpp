// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/io/robot_files.h"

#include "cad2slam/geometry/angle.h"
#include "cad2slam/io/text.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace cad2slam {
namespace {

using Eigen::Vector2d;
using Json = nlohmann::ordered_json;

std::string pairOf(const Vector2d& place) {
  std::string text = "[";
  text += formatNumber(place.x()) + ", " + formatNumber(place.y());
  return text + "]";
}

/// A double-quoted text is the same in JSON and YAML.
std::string quoted(const std::string& text) {
  return Json(text).dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string references(const LevelTransform& transform, Vector2d PointPair::*side) {
  std::string list = "[";
  for (const PointPair& pair : transform.references) list += (list.size() > 1 ? ", " : "") + pairOf(pair.*side);
  return list + "]";
}

std::string metres(double value) {
  return formatNumber(std::round(value * 1000.0) / 1000.0) + " m";
}

/// Node whose centre is nearest to a place.
std::size_t nearestNode(const ProjectorData& data, const Vector2d& place) {
  std::size_t best = 0;
  double best_squared = std::numeric_limits<double>::infinity();
  for (std::size_t node = 0; node < data.node_blueprint.size(); ++node) {
    const double squared = (data.node_blueprint[node] - place).squaredNorm();
    if (squared >= best_squared) continue;
    best_squared = squared;
    best = node;
  }
  return best;
}

std::string spaced(std::initializer_list<double> numbers) {
  std::string text;
  for (const double number : numbers) text.append(" ").append(formatNumber(number));
  return text;
}

}  // namespace

std::string formatRmfTransform(const LevelTransform& transform, const std::string& level) {
  const Similarity2& fit = transform.slam_from_blueprint;
  std::string text = "# One similarity for a map that bends: what is left at " + std::to_string(transform.places) +
                     " places is " + metres(transform.rms_m) + " (root mean square)\n# and at most " +
                     metres(transform.max_m) + ", at " + pairOf(transform.worst_in_blueprint) + " of the blueprint";
  if (!transform.worst_name.empty()) text += " " + quoted(transform.worst_name);
  text += ".\n# c2s_rmf.py takes the projector itself instead, without this rest.\n";
  text += "reference_coordinates:\n  " + quoted(level) + ":\n    rmf: " + references(transform, &PointPair::source) +
          "\n    robot: " + references(transform, &PointPair::target) + "\n";
  text += "rmf_fleet:\n  transforms:\n    " + quoted(level) +
          ":\n      rotation: " + formatNumber(wrapAngle(fit.heading)) + "\n      scale: " + formatNumber(fit.scale) +
          "\n      translation: " + pairOf(fit.translation) + "\n";
  return text;
}

Result<std::string> formatNav2Waypoints(const FeatureList& features) {
  std::string text = "waypoints:\n";
  std::size_t count = 0;
  for (const Feature& feature : features) {
    if (feature.kind != FeatureKind::kPoint) continue;
    const double half = 0.5 * feature.heading.value_or(0.0);
    for (const PointList& part : feature.parts) {
      text += "  waypoint" + std::to_string(count++) + ":";
      if (!feature.name.empty()) text += "  # " + quoted(feature.name);
      text += "\n    pose: [" + formatNumber(part.front().x()) + ", " + formatNumber(part.front().y()) +
              ", 0]\n    orientation: [" + formatNumber(std::cos(half)) + ", 0, 0, " + formatNumber(std::sin(half)) +
              "]\n";
    }
  }
  if (count == 0) return fail(ErrorCode::kOutOfDomain, "waypoints need at least one point, and there is none");
  return text;
}

std::string formatTinshift(const TriangleMesh& mesh, const std::string& name) {
  Json vertices = Json::array();
  for (const PointPair& vertex : mesh.vertices) {
    vertices.push_back({vertex.source.x(), vertex.source.y(), vertex.target.x(), vertex.target.y()});
  }
  const Json document = {
      {"file_type", "triangulation_file"},
      {"format_version", "1.0"},
      {"name", name},
      {"description", "From the blueprint frame to the SLAM frame, metres. Between the vertices up to " +
                          metres(mesh.max_deviation_m) + " from the projector."},
      {"transformed_components", {"horizontal"}},
      {"vertices_columns", {"source_x", "source_y", "target_x", "target_y"}},
      {"triangles_columns", {"idx_vertex1", "idx_vertex2", "idx_vertex3"}},
      {"vertices", std::move(vertices)},
      {"triangles", mesh.triangles}};
  return document.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string formatG2o(const ProjectorData& data) {
  std::string text;
  for (std::size_t node = 0; node < data.node_slam.size(); ++node) {
    const Pose2& pose = data.node_slam[node];
    text += "VERTEX_SE2 " + std::to_string(node) +
            spaced({pose.translation.x(), pose.translation.y(), wrapAngle(pose.heading)}) + "\n";
  }
  for (const auto& [from, to] : data.edges) {
    const Vector2d rest = data.info.scale * (data.node_blueprint[to] - data.node_blueprint[from]);
    // Along the edge 1, across it 10, heading 10: turned from the edge's axes into those of the node.
    const Vector2d u = rest.norm() > 0.0 ? Vector2d(rest.normalized()) : Vector2d(1.0, 0.0);
    const double xx = u.x() * u.x() + 10.0 * u.y() * u.y();
    const double xy = (1.0 - 10.0) * u.x() * u.y();
    const double yy = u.y() * u.y() + 10.0 * u.x() * u.x();
    text += "EDGE_SE2 " + std::to_string(from) + " " + std::to_string(to) +
            spaced({rest.x(), rest.y(), 0.0, xx, xy, 0.0, yy, 0.0, 10.0}) + "\n";
  }
  for (std::size_t k = 0; k < data.anchors.size(); ++k) {
    const auto& anchor = data.anchors[k];
    const Vector2d in_blueprint(anchor[0], anchor[1]);
    const std::size_t node = nearestNode(data, in_blueprint);
    const Vector2d offset = data.info.scale * (in_blueprint - data.node_blueprint[node]);
    const std::string id = std::to_string(data.node_slam.size() + k);
    text += "VERTEX_XY " + id + spaced({anchor[2], anchor[3]}) + "\nFIX " + id + "\nEDGE_SE2_XY " +
            std::to_string(node) + " " + id + spaced({offset.x(), offset.y(), 100.0, 0.0, 100.0}) + "\n";
  }
  return text;
}

std::string formatNpy(const PoseGrid& grid) {
  static_assert(std::endian::native == std::endian::little);
  std::string header = "{'descr': '<f8', 'fortran_order': False, 'shape': (" + std::to_string(grid.rows) + ", " +
                       std::to_string(grid.columns) + ", 3), }";
  constexpr std::size_t kPreamble = 10;  // magic, version 1.0, length of the header
  header.append(63 - (kPreamble + header.size()) % 64, ' ');
  header += '\n';
  std::string bytes("\x93NUMPY\x01\x00", 8);
  bytes += static_cast<char>(header.size() & 0xffU);
  bytes += static_cast<char>(header.size() >> 8);
  bytes += header;
  bytes.reserve(bytes.size() + grid.images.size() * 3 * sizeof(double));
  for (const Pose2& image : grid.images) {
    const double numbers[] = {image.translation.x(), image.translation.y(), image.heading};
    bytes.append(reinterpret_cast<const char*>(numbers), sizeof numbers);
  }
  return bytes;
}

std::string formatGridDescription(const PoseGrid& grid, const std::string& npy_name, const std::string& source_frame,
                                  const std::string& target_frame) {
  const Json document = {{"grid", npy_name},
                         {"shape", {grid.rows, grid.columns, 3}},
                         {"columns", {"x_m", "y_m", "turn_rad"}},
                         {"from_frame", source_frame},
                         {"to_frame", target_frame},
                         {"first_x_m", grid.first.x()},
                         {"first_y_m", grid.first.y()},
                         {"step_m", grid.step_m},
                         {"max_deviation_m", grid.max_deviation_m}};
  return document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace cad2slam
