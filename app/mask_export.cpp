// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "app/mask_export.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/cli_options.h"
#include "app/feature_input.h"
#include "cad2slam/exports/zone_mask.h"
#include "cad2slam/io/map_file.h"
#include "cad2slam/io/projector_file.h"

namespace cad2slam::cli {
namespace {

struct MaskOptions {
  std::string projector;
  std::string zones;
  std::string map;
  std::string output;
  std::optional<OutsidePolicy> outside;
  double buffer_m = 0.1;
  double chord_error_m = 0.01;
  bool only_inside = false;
};

/// The raster of the SLAM map. nav2 ignores a yaw, so a turned one is replaced by the upright one around it.
Result<MapFrame> maskFrame(const MaskOptions& options, const FrameInfo& slam) {
  std::optional<MapFrame> map;
  if (!options.map.empty()) {
    const Result<MapYaml> yaml = readMapYaml(options.map);
    if (!yaml) return failAs(yaml);
    const Result<MapFrame> frame = readMapFrame(yaml->metadata);
    if (!frame) return failAs(frame);
    map = *frame;
  } else {
    if (slam.width_px <= 0 || slam.height_px <= 0) {
      return fail(ErrorCode::kNotFound, "the projector does not say which raster its SLAM map has; give --map",
                  options.projector);
    }
    const Result<MapFrame> frame =
        MapFrame::create(slam.resolution_m_per_px, slam.width_px, slam.height_px, slam.metric_from_corner);
    if (!frame) return failAs(frame);
    map = *frame;
  }
  if (map->metricFromCorner().heading == 0.0) return *map;
  Eigen::Vector2d low = map->metricFromPixel({0.0, 0.0});
  Eigen::Vector2d high = low;
  for (const Eigen::Vector2d& corner : {Eigen::Vector2d(map->width(), 0.0), Eigen::Vector2d(0.0, map->height()),
                                        Eigen::Vector2d(map->width(), map->height())}) {
    low = low.cwiseMin(map->metricFromPixel(corner));
    high = high.cwiseMax(map->metricFromPixel(corner));
  }
  const Eigen::Vector2d size = (high - low) / map->resolution();
  return MapFrame::create(map->resolution(), static_cast<int>(std::ceil(size.x())),
                          static_cast<int>(std::ceil(size.y())), {low, 0.0});
}

/// Each polygon on its own: polygons of one feature may overlap. What the written edges may miss goes to the buffer.
std::vector<MaskZone> maskZonesOf(const Feature& feature, const MaskOptions& options) {
  const double polygon_buffer = options.buffer_m + options.chord_error_m;
  if (feature.kind != FeatureKind::kPolygon) {
    const double width = options.only_inside ? options.buffer_m - options.chord_error_m : polygon_buffer;
    return {{{}, feature.parts, std::max(0.0, width)}};
  }
  std::vector<MaskZone> zones;
  std::size_t ring = 0;
  const std::vector<std::size_t> counts =
      feature.rings_of_polygon.empty() ? std::vector<std::size_t>{feature.parts.size()} : feature.rings_of_polygon;
  for (const std::size_t count : counts) {
    MaskZone zone;
    for (std::size_t k = 0; k < count; ++k) zone.rings.push_back(feature.parts[ring++]);
    zone.buffer_m = polygon_buffer;
    zones.push_back(std::move(zone));
  }
  return zones;
}

Result<void> writeMask(const MaskOptions& options, const MapFrame& frame, const cv::Mat& mask, MapMode mode) {
  MapMetadata metadata;
  metadata.resolution_m_per_px = frame.resolution();
  metadata.metric_from_corner = frame.metricFromCorner();
  metadata.mode = mode;
  if (mode == MapMode::kScale) {
    metadata.free_threshold = 0.0;
    metadata.occupied_threshold = 1.0;
  }
  const std::filesystem::path yaml = options.output;
  const std::string image_name = yaml.stem().string() + ".pgm";
  if (Result<void> written = writeMap(yaml, image_name, mask, metadata); !written) return written;
  fmt::print("written: {} and {} ({} x {} px)\n", options.output, image_name, frame.width(), frame.height());
  std::fflush(stdout);
  return {};
}

struct MaskInputs {
  MapFrame frame;        ///< of the mask
  FeatureList features;  ///< in the SLAM map
};

Result<MaskInputs> loadInputs(const MaskOptions& options) {
  const Result<Projector> projector = loadProjector(options.projector);
  if (!projector) return failAs(projector);
  Result<MapFrame> frame = maskFrame(options, projector->info().slam);
  if (!frame) return failAs(frame);
  const OutsidePolicy outside = options.outside.value_or(projector->info().outside);
  Result<WarpedFeatures> zones =
      readWarpedFeatures(options.zones, *projector, {WarpDirection::kToSlam, outside, options.chord_error_m});
  if (!zones) return failAs(zones);
  return MaskInputs{std::move(*frame), std::move(zones->features)};
}

Result<void> exportKeepout(const MaskOptions& options) {
  const Result<MaskInputs> inputs = loadInputs(options);
  if (!inputs) return failAs(inputs);
  const auto& [frame, features] = *inputs;
  std::vector<MaskZone> zones;
  for (const Feature& feature : features) {
    if (feature.kind == FeatureKind::kPoint) continue;
    for (MaskZone& zone : maskZonesOf(feature, options)) zones.push_back(std::move(zone));
  }
  if (zones.empty())
    return fail(ErrorCode::kOutOfDomain, "there is no path and no polygon to keep out of", options.zones);
  const Result<cv::Mat> mask = keepoutMask(frame, zones, options.only_inside);
  if (!mask) return failAs(mask);
  return writeMask(options, frame, *mask, MapMode::kTrinary);
}

/// `speed_percent` of a feature; features without are no speed zones.
std::optional<double> speedOf(const Feature& feature) {
  const nlohmann::json properties = nlohmann::json::parse(feature.properties, nullptr, false);
  if (!properties.is_object() || !properties.contains("speed_percent")) return std::nullopt;
  const nlohmann::json& value = properties["speed_percent"];
  return value.is_number() ? value.get<double>() : -1.0;
}

Result<void> exportSpeed(const MaskOptions& options) {
  const Result<MaskInputs> inputs = loadInputs(options);
  if (!inputs) return failAs(inputs);
  const auto& [frame, features] = *inputs;
  std::vector<SpeedZone> zones;
  for (std::size_t k = 0; k < features.size(); ++k) {
    const Feature& feature = features[k];
    const std::optional<double> percent = speedOf(feature);
    if (!percent || feature.kind == FeatureKind::kPoint) continue;
    if (!(*percent >= 1.0 && *percent <= 100.0)) {
      return fail(ErrorCode::kMalformed, "speed_percent must be a number from 1 to 100",
                  options.zones + ": " + titleOf(feature, k));
    }
    for (MaskZone& zone : maskZonesOf(feature, options)) zones.push_back({std::move(zone), *percent});
  }
  if (zones.empty()) return fail(ErrorCode::kOutOfDomain, "no feature has the property speed_percent", options.zones);
  const Result<cv::Mat> mask = speedMask(frame, zones);
  if (!mask) return failAs(mask);
  return writeMask(options, frame, *mask, MapMode::kScale);
}

CLI::App* addMask(CLI::App& parent, ActionSlot& chosen, const std::shared_ptr<MaskOptions>& options, const char* name,
                  const char* what, Result<void> (*run)(const MaskOptions&)) {
  CLI::App* command = parent.add_subcommand(name, what);
  command->add_option("projector", options->projector, "Projector file (.c2s)")->required();
  command->add_option("zones", options->zones, "Polygons and paths on the blueprint: GeoJSON or CSV, metres")
      ->required();
  command->add_option("-o,--output", options->output, "YAML to write; the PGM is written beside it")->required();
  command->add_option("--buffer", options->buffer_m, "Safety distance around the zones [m]")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  command->add_option("--map", options->map, "Map whose raster the mask gets (default: the projector's SLAM map)");
  command->add_option("--chord-error", options->chord_error_m, "Of bent edges, added to the buffer [m]")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  addOutside(*command, options->outside);
  command->callback([options, &chosen, run] { chosen.set([options, run] { return run(*options); }); });
  return command;
}

}  // namespace

void addMaskExports(CLI::App& parent, ActionSlot& chosen) {
  const auto options = std::make_shared<MaskOptions>();
  CLI::App* keepout = addMask(parent, chosen, options, "keepout",
                              "Mask for nav2's KeepoutFilter: no pixel of a zone is left out", exportKeepout);
  keepout->add_flag("--only-inside", options->only_inside,
                    "Keep out of everything but the zones: polygons less the buffer, paths of that half width");
  addMask(parent, chosen, options, "speed", "Mask for nav2's SpeedFilter from polygons with the property speed_percent",
          exportSpeed);
}

}  // namespace cad2slam::cli
