// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "app/cli_command.h"
#include "cad2slam/io/anchors_csv.h"
#include "cad2slam/io/atomic_file.h"
#include "cad2slam/io/geojson_file.h"
#include "cad2slam/io/map_file.h"
#include "cad2slam/io/projector_file.h"
#include "cad2slam/io/rmf_building.h"

namespace cad2slam::cli {
namespace {

using Json = nlohmann::ordered_json;

struct InfoOptions {
  std::string projector;
  bool json = false;
};

struct ConvertOptions {
  std::string input;
  std::string output;
  std::string blueprint;
  std::string slam;
  std::string level;
  std::string layer;
};

Json toJson(const FrameInfo& frame) {
  return {{"name", frame.name},
          {"image_sha256", frame.image_sha256},
          {"resolution_m_per_px", frame.resolution_m_per_px},
          {"width_px", frame.width_px},
          {"height_px", frame.height_px},
          {"origin",
           {frame.metric_from_corner.translation.x(), frame.metric_from_corner.translation.y(),
            frame.metric_from_corner.heading}}};
}

Json toJson(const ProjectorData& data) {
  const ProjectorInfo& info = data.info;
  return {{"model", info.model},
          {"scale", info.scale},
          {"weights", info.weights == BlendWeights::kSmooth ? "smooth" : "paper"},
          {"outside", info.outside == OutsidePolicy::kError ? "error" : "rigid"},
          {"cell_size_m", info.lattice.cell_size},
          {"nodes", data.node_blueprint.size()},
          {"edges", data.edges.size()},
          {"anchors", data.anchors.size()},
          {"check_poses", data.check_poses.size()},
          {"blueprint", toJson(info.blueprint)},
          {"slam", toJson(info.slam)},
          {"quality",
           {{"anchors_used", info.quality.anchors_used},
            {"residual_rms_m", info.quality.anchor_rms_m},
            {"residual_max_m", info.quality.anchor_max_m},
            {"leave_one_out_mean_m", info.quality.leave_one_out_mean_m},
            {"leave_one_out_median_m", info.quality.leave_one_out_median_m},
            {"leave_one_out_max_m", info.quality.leave_one_out_max_m},
            {"folded_tiles", info.quality.folded_tiles}}},
          {"creator", info.creator},
          {"created", info.created},
          {"project", info.project},
          {"note", info.note}};
}

void printFrame(const char* label, const FrameInfo& frame) {
  fmt::print("{:<10} {} ({} x {} px at {} m/px, image {}...)\n", label, frame.name, frame.width_px, frame.height_px,
             frame.resolution_m_per_px, frame.image_sha256.substr(0, 12));
}

Result<void> showInfo(const InfoOptions& options) {
  const Result<ProjectorData> data = readProjectorFile(options.projector);
  if (!data) return failAs(data);
  if (options.json) {
    std::cout << toJson(*data).dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
    return {};
  }
  const ProjectorInfo& info = data->info;
  printFrame("blueprint", info.blueprint);
  printFrame("SLAM map", info.slam);
  fmt::print("{:<10} {} model, scale {:.6f}, {} nodes on cells of {:.4g} m, {} edges\n", "mesh", info.model, info.scale,
             data->node_blueprint.size(), info.lattice.cell_size, data->edges.size());
  fmt::print("{:<10} {} weights, outside the mesh: {}\n", "projects",
             info.weights == BlendWeights::kSmooth ? "smooth" : "paper",
             info.outside == OutsidePolicy::kError ? "error" : "rigid");
  fmt::print("{:<10} {} anchors, residual rms {:.3f} m, without the anchor itself {:.3f} m (mean), {} folded tiles\n",
             "quality", info.quality.anchors_used, info.quality.anchor_rms_m, info.quality.leave_one_out_mean_m,
             info.quality.folded_tiles);
  fmt::print("{:<10} {}{}{}\n", "made by", info.creator, info.created.empty() ? "" : " on ", info.created);
  if (!info.project.empty()) fmt::print("{:<10} {}\n", "project", info.project);
  if (!info.note.empty()) fmt::print("{:<10} {}\n", "note", info.note);
  fmt::print("{:<10} {} poses, all reproduced\n", "checked", data->check_poses.size());
  std::fflush(stdout);
  return {};
}

Result<void> convertAnchors(const ConvertOptions& options) {
  const Result<AnchorImport> anchors = readAnchors(options.input);
  if (!anchors) return failAs(anchors);
  for (const RejectedLine& line : anchors->rejected) {
    std::cerr << "cad2slam-cli: warning: " << options.input << ':' << line.line << ": line skipped: " << line.reason
              << '\n';
  }
  if (Result<void> written = writeAnchorsCsv(options.output, anchors->anchors); !written) return written;
  fmt::print("written: {} ({} anchors)\n", options.output, anchors->anchors.size());
  std::fflush(stdout);
  return {};
}

Result<MapFrame> frameOf(const std::string& yaml) {
  const Result<MapYaml> read = readMapYaml(yaml);
  if (!read) return failAs(read);
  return readMapFrame(read->metadata);
}

Result<RmfLevel> readLevel(const ConvertOptions& options) {
  const Result<RmfBuilding> building = readRmfBuilding(options.input);
  if (!building) return failAs(building);
  Result<RmfLevel> level = findLevel(*building, options.level);
  if (!level) return fail(level.error().code, level.error().message, options.input);
  return level;
}

Result<void> convertRmf(const ConvertOptions& options) {
  const Result<RmfLevel> level = readLevel(options);
  if (!level) return failAs(level);
  const Result<MapFrame> blueprint = frameOf(options.blueprint);
  if (!blueprint) return failAs(blueprint);
  const Result<MapFrame> slam = frameOf(options.slam);
  if (!slam) return failAs(slam);
  const Result<AnchorList> anchors = anchorsOf(*level, options.layer, *blueprint, *slam);
  if (!anchors) return fail(anchors.error().code, anchors.error().message, options.input);
  if (Result<void> written = writeAnchorsCsv(options.output, *anchors); !written) return written;
  fmt::print("written: {} ({} anchors)\n", options.output, anchors->size());
  std::fflush(stdout);
  return {};
}

Result<void> convertLanes(const ConvertOptions& options) {
  const Result<RmfLevel> level = readLevel(options);
  if (!level) return failAs(level);
  const Result<MapFrame> blueprint = frameOf(options.blueprint);
  if (!blueprint) return failAs(blueprint);
  const FeatureList lanes = lanesOf(*level, *blueprint);
  const Result<std::string> text = formatGeoJson(lanes, "blueprint");
  if (!text) return failAs(text);
  if (Result<void> written = writeFileAtomically(options.output, *text); !written) return written;
  fmt::print("written: {} ({} lanes and named places)\n", options.output, lanes.size());
  std::fflush(stdout);
  return {};
}

}  // namespace

void addInfoCommand(CLI::App& app, ActionSlot& chosen) {
  auto options = std::make_shared<InfoOptions>();
  CLI::App* command = app.add_subcommand("info", "Check a projector file and say what it holds");
  command->add_option("projector", options->projector, "Projector file (.c2s)")->required();
  command->add_flag("--json", options->json, "Print one JSON object");
  command->callback([options, &chosen] { chosen.set([options] { return showInfo(*options); }); });
}

void addConvertCommand(CLI::App& app, ActionSlot& chosen) {
  CLI::App* command = app.add_subcommand("convert", "Convert between file formats");
  command->require_subcommand(1);
  auto options = std::make_shared<ConvertOptions>();
  CLI::App* anchors =
      command->add_subcommand("anchors", "Anchors: .data of the paper's authors, or any CSV, to our CSV");
  anchors->add_option("input", options->input, "Anchors to read")->required();
  anchors->add_option("-o,--output", options->output, "CSV to write")->required();
  anchors->callback([options, &chosen] { chosen.set([options] { return convertAnchors(*options); }); });

  CLI::App* rmf = command->add_subcommand("rmf", "Marks that Open-RMF's traffic editor joins, to anchors");
  CLI::App* lanes = command->add_subcommand("rmf-lanes", "Lanes of Open-RMF's traffic editor, to GeoJSON");
  for (CLI::App* building : {rmf, lanes}) {
    building->add_option("input", options->input, "Building to read (.building.yaml)")->required();
    building->add_option("--blueprint", options->blueprint, "The level's drawing as a map_server YAML")->required();
    building->add_option("--level", options->level, "Level (default: the only one)");
    building->add_option("-o,--output", options->output, "File to write")->required();
  }
  rmf->add_option("--slam", options->slam, "The layer's picture as a map_server YAML")->required();
  rmf->add_option("--layer", options->layer, "Layer with the robot's map (default: the only one)");
  rmf->callback([options, &chosen] { chosen.set([options] { return convertRmf(*options); }); });
  lanes->callback([options, &chosen] { chosen.set([options] { return convertLanes(*options); }); });
}

}  // namespace cad2slam::cli
