// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/io/qgis_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cad2slam/geometry/similarity_fit.h"
#include "cad2slam/io/atomic_file.h"
#include "cad2slam/io/delimited_text.h"
#include "cad2slam/io/text.h"

namespace cad2slam {
namespace {

using Eigen::Vector2d;

constexpr std::size_t kLargestFile = std::size_t{64} << 20;
constexpr std::size_t kMostRejected = 10'000;

enum Column : std::size_t { kMapX, kMapY, kSourceX, kSourceY, kEnable, kColumnCount };
using Layout = std::array<std::optional<std::size_t>, kColumnCount>;

std::optional<Layout> layoutOf(const TextRecord& header) {
  constexpr std::array<std::string_view, kColumnCount> kNames{"mapx", "mapy", "sourcex", "sourcey", "enable"};
  constexpr std::array<std::string_view, kColumnCount> kOldNames{"mapx", "mapy", "pixelx", "pixely", "enable"};
  Layout layout;
  for (std::size_t field = 0; field < header.fields.size(); ++field) {
    const std::string name = lowerCase(header.fields[field]);
    for (std::size_t column = 0; column < kColumnCount; ++column) {
      if (name == kNames[column] || name == kOldNames[column]) layout[column] = field;
    }
  }
  const bool is_whole = std::all_of(layout.begin(), layout.begin() + kEnable, [](const auto& at) { return at; });
  return is_whole ? std::optional(layout) : std::nullopt;
}

struct ControlPoint {
  Vector2d map;
  Vector2d source;
  bool enabled = true;
};

tl::expected<ControlPoint, std::string> parsePoint(const TextRecord& record, const Layout& layout) {
  if (!record.complaint.empty()) return tl::unexpected(record.complaint);
  std::array<double, kEnable> numbers{};
  for (std::size_t column = 0; column < kEnable; ++column) {
    if (*layout[column] >= record.fields.size()) return tl::unexpected(std::string("has too few fields"));
    const std::string& field = record.fields[*layout[column]];
    const std::optional<double> number = parseNumber(field);
    if (!number) return tl::unexpected(excerpt(field) + " is not a finite number");
    if (std::abs(*number) > kLargestCoordinate)
      return tl::unexpected(excerpt(field) + " is too large for a coordinate");
    numbers[column] = *number;
  }
  ControlPoint point{{numbers[kMapX], numbers[kMapY]}, {numbers[kSourceX], numbers[kSourceY]}, true};
  if (layout[kEnable] && *layout[kEnable] < record.fields.size()) {
    const std::string& field = record.fields[*layout[kEnable]];
    const std::optional<bool> enabled = parseSwitch(field);
    if (!enabled) return tl::unexpected("enable is " + excerpt(field) + ", not 1 or 0");
    point.enabled = *enabled;
  }
  return point;
}

AnchorList anchorsFrom(const std::vector<ControlPoint>& points, const QgisReading& reading, const MapFrame& blueprint,
                       const MapFrame& slam) {
  const MapFrame& source_frame = reading.slam_is_source ? slam : blueprint;
  const MapFrame& target_frame = reading.slam_is_source ? blueprint : slam;
  const auto fromPicture = [](const MapFrame& frame, const Vector2d& point) {
    return frame.metricFromPixel({point.x(), -point.y()});
  };
  AnchorList anchors;
  for (const ControlPoint& point : points) {
    const Vector2d source = fromPicture(source_frame, point.source);
    const Vector2d target = reading.target_in_pixels ? fromPicture(target_frame, point.map) : point.map;
    Anchor anchor;
    anchor.id = static_cast<AnchorId>(anchors.size()) + 1;
    anchor.in_blueprint = reading.slam_is_source ? target : source;
    anchor.in_slam = reading.slam_is_source ? source : target;
    anchor.enabled = point.enabled;
    anchors.push_back(std::move(anchor));
  }
  return anchors;
}

/// What a rotation and a shift leave [m], as both maps are true to scale; infinite where a point lies outside of a map.
double misfitOf(const AnchorList& anchors, const MapFrame& blueprint, const MapFrame& slam) {
  std::vector<PointPair> pairs;
  for (const Anchor& anchor : anchors) {
    if (!anchor.enabled) continue;
    if (!blueprint.contains(anchor.in_blueprint) || !slam.contains(anchor.in_slam)) {
      return std::numeric_limits<double>::infinity();
    }
    pairs.push_back({anchor.in_blueprint, anchor.in_slam});
  }
  const Result<Similarity2> fit = fitSimilarity(pairs, 1.0);
  return fit ? rmsResidual(*fit, pairs) : 0.0;
}

}  // namespace

bool looksLikeQgisPoints(std::string_view text) {
  const std::optional<TextRecord> header = RecordReader(withoutByteOrderMark(text).substr(0, 4096), ',').next();
  return header && layoutOf(*header);
}

Result<QgisImport> parseQgisPoints(std::string_view text, const std::string& file_name, const MapFrame& blueprint,
                                   const MapFrame& slam) {
  RecordReader reader(withoutByteOrderMark(text), ',');
  const std::optional<TextRecord> header = reader.next();
  const std::optional<Layout> layout = header ? layoutOf(*header) : std::nullopt;
  if (!layout) {
    return fail(ErrorCode::kMalformed, "has no header with the columns mapX, mapY, sourceX and sourceY", file_name);
  }
  std::vector<ControlPoint> points;
  QgisImport result;
  while (const std::optional<TextRecord> record = reader.next()) {
    const tl::expected<ControlPoint, std::string> point = parsePoint(*record, *layout);
    if (point) {
      points.push_back(*point);
    } else if (result.import.rejected.size() < kMostRejected) {
      result.import.rejected.push_back({record->line, point.error()});
    } else {
      return fail(ErrorCode::kMalformed, "more than " + std::to_string(kMostRejected) + " lines are no points",
                  file_name + ":" + std::to_string(record->line));
    }
  }
  if (points.empty()) return fail(ErrorCode::kMalformed, "holds no points", file_name);

  // In the order in which people work: the SLAM map is bent onto a blueprint that has a scale.
  double best = std::numeric_limits<double>::infinity();
  for (const QgisReading& reading : {QgisReading{true, false}, {true, true}, {false, false}, {false, true}}) {
    AnchorList anchors = anchorsFrom(points, reading, blueprint, slam);
    const double misfit_m = misfitOf(anchors, blueprint, slam);
    if (!(misfit_m < best)) continue;
    best = misfit_m;
    result.reading = reading;
    result.import.anchors = std::move(anchors);
  }
  if (result.import.anchors.empty()) {
    return fail(ErrorCode::kDegenerate,
                "its points do not lie in these two maps, neither as metres nor as pixels; were they made with them?",
                file_name);
  }
  return result;
}

Result<QgisImport> readQgisPoints(const std::filesystem::path& path, const MapFrame& blueprint, const MapFrame& slam) {
  const Result<std::string> text = readFile(path, kLargestFile);
  if (!text) return failAs(text);
  return parseQgisPoints(*text, path.string(), blueprint, slam);
}

}  // namespace cad2slam
