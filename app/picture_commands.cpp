// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "app/cli_command.h"
#include "app/cli_options.h"
#include "cad2slam/io/map_file.h"
#include "cad2slam/io/projector_file.h"
#include "cad2slam/projection/overlay_picture.h"
#include "cad2slam/projection/raster_warper.h"

namespace cad2slam::cli {
namespace {

struct WarpCommandOptions {
  std::string projector;
  std::string image;
  std::string output;
  WarpDirection direction = WarpDirection::kToSlam;
  double resolution = 0.0;
  MapSemantics semantics = MapSemantics::kJazzy;
};

struct PreviewOptions {
  std::string projector;
  std::string blueprint;
  std::string slam;
  std::string output;
};

/// The frame of the map on the target side as the projector file describes it; else everything that can be drawn.
Result<MapFrame> targetFrame(const Projector& projector, const FrameInfo& target, WarpDirection direction,
                             const MapFrame& source, double resolution) {
  const bool described = target.width_px > 0 && target.height_px > 0 && target.resolution_m_per_px > 0.0;
  if (described && resolution <= 0.0) {
    return MapFrame::create(target.resolution_m_per_px, target.width_px, target.height_px, target.metric_from_corner);
  }
  const double fallback = direction == WarpDirection::kToSlam ? source.resolution() * projector.info().scale
                                                              : source.resolution() / projector.info().scale;
  return warpedExtent(projector, direction, source, resolution > 0.0 ? resolution : fallback);
}

Result<void> warp(const WarpCommandOptions& options) {
  const Result<Projector> projector = loadProjector(options.projector);
  if (!projector) return failAs(projector);
  const Result<LoadedMap> map = loadMap(options.image, {options.semantics});
  if (!map) return failAs(map);
  for (const std::string& warning : map->warnings) std::cerr << "cad2slam-cli: warning: " << warning << '\n';
  const bool to_slam = options.direction == WarpDirection::kToSlam;
  const FrameInfo& target = to_slam ? projector->info().slam : projector->info().blueprint;
  const Result<MapFrame> frame =
      targetFrame(*projector, target, options.direction, map->grid.frame(), options.resolution);
  if (!frame) return failAs(frame);
  const Result<OccupancyGrid> warped = warpGrid(*projector, to_slam, map->grid, *frame);
  if (!warped) return failAs(warped);

  MapMetadata metadata;  // map_server's own trinary thresholds keep 205 unknown
  metadata.resolution_m_per_px = frame->resolution();
  metadata.metric_from_corner = frame->metricFromCorner();
  const std::filesystem::path yaml = options.output;
  const std::string image_name = yaml.stem().string() + ".png";
  if (Result<void> written = writeMap(yaml, image_name, trinaryPicture(*warped), metadata); !written) return written;
  fmt::print("written: {} and {} ({} x {} px)\n", options.output, image_name, frame->width(), frame->height());
  std::fflush(stdout);
  return {};
}

Result<void> preview(const PreviewOptions& options) {
  const Result<ProjectorData> data = readProjectorFile(options.projector);
  if (!data) return failAs(data);
  const Result<Projector> projector = Projector::create(*data);
  if (!projector) return failAs(projector);
  const Result<LoadedMap> blueprint = loadMap(options.blueprint);
  if (!blueprint) return failAs(blueprint);
  const Result<LoadedMap> slam = loadMap(options.slam);
  if (!slam) return failAs(slam);
  std::vector<OverlayAnchor> anchors;
  for (const auto& anchor : data->anchors) anchors.push_back({{anchor[0], anchor[1]}, {anchor[2], anchor[3]}});
  const Result<cv::Mat> picture = drawOverlay(*projector, blueprint->grid, slam->grid, anchors);
  if (!picture) return failAs(picture);
  if (Result<void> written = writePicture(options.output, *picture); !written) return written;
  fmt::print("written: {} ({} x {} px; blueprint magenta, SLAM map green, dark where they agree)\n", options.output,
             picture->cols, picture->rows);
  std::fflush(stdout);
  return {};
}

}  // namespace

void addWarpCommand(CLI::App& app, ActionSlot& chosen) {
  auto options = std::make_shared<WarpCommandOptions>();
  CLI::App* command = app.add_subcommand("warp", "Draw a whole map in the other frame, as a map_server map");
  command->add_option("projector", options->projector, "Projector file (.c2s)")->required();
  command->add_option("image", options->image, "Map to draw (map_server YAML)")->required();
  addDirection(*command, options->direction, "Frame to draw in");
  command
      ->add_option("--resolution", options->resolution,
                   "Metres per pixel (default: raster and resolution of the map the projector was made for)")
      ->check(CLI::PositiveNumber);
  addSemantics(*command, options->semantics);
  command->add_option("-o,--output", options->output, "YAML to write; the PNG is written beside it")->required();
  command->callback([options, &chosen] { chosen.set([options] { return warp(*options); }); });
}

void addPreviewCommand(CLI::App& app, ActionSlot& chosen) {
  auto options = std::make_shared<PreviewOptions>();
  CLI::App* command = app.add_subcommand("preview", "Draw the warped blueprint over the SLAM map as a PNG");
  command->add_option("projector", options->projector, "Projector file (.c2s)")->required();
  command->add_option("--blueprint", options->blueprint, "Blueprint (map_server YAML)")->required();
  command->add_option("--slam", options->slam, "SLAM map (map_server YAML)")->required();
  command->add_option("-o,--output", options->output, "PNG to write")->required();
  command->callback([options, &chosen] { chosen.set([options] { return preview(*options); }); });
}

}  // namespace cad2slam::cli
