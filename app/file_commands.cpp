// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "app/cli_command.h"
#include "cad2slam/io/anchors_csv.h"
#include "cad2slam/io/projector_file.h"

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
}

}  // namespace cad2slam::cli
