// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/cli_command.h"
#include "app/cli_options.h"
#include "app/feature_input.h"
#include "app/mask_export.h"
#include "cad2slam/exports/feature_warp.h"
#include "cad2slam/exports/grid_sampling.h"
#include "cad2slam/exports/similarity_export.h"
#include "cad2slam/exports/triangulation.h"
#include "cad2slam/io/atomic_file.h"
#include "cad2slam/io/feature_csv.h"
#include "cad2slam/io/geojson_file.h"
#include "cad2slam/io/projector_file.h"
#include "cad2slam/io/robot_files.h"

namespace cad2slam::cli {
namespace {

struct ExportOptions {
  std::string projector;
  std::string features;
  std::string output;
  WarpDirection direction = WarpDirection::kToSlam;
  std::optional<OutsidePolicy> outside;
  double chord_error_m = 0.01;
  std::string level = "L1";
  double spacing_m = 0.5;
  std::size_t references = 24;
  std::size_t vertices = 10000;
  double step_m = 0.25;
};

void report(const std::string& line) {
  fmt::print("{}\n", line);
  std::fflush(stdout);
}

Result<WarpedFeatures> warpedFeatures(const Projector& projector, const ExportOptions& options) {
  const OutsidePolicy outside = options.outside.value_or(projector.info().outside);
  return readWarpedFeatures(options.features, projector, {options.direction, outside, options.chord_error_m});
}

Result<void> exportFeatures(const ExportOptions& options) {
  const Result<Projector> projector = loadProjector(options.projector);
  if (!projector) return failAs(projector);
  const Result<WarpedFeatures> warped = warpedFeatures(*projector, options);
  if (!warped) return failAs(warped);
  const bool to_slam = options.direction == WarpDirection::kToSlam;
  const FrameInfo& frame = to_slam ? projector->info().slam : projector->info().blueprint;
  const std::string frame_name = !frame.name.empty() ? frame.name : to_slam ? "slam" : "blueprint";
  const bool csv = std::filesystem::path(options.output).extension() == ".csv";
  const Result<std::string> text =
      csv ? Result<std::string>(formatFeatureCsv(warped->features)) : formatGeoJson(warped->features, frame_name);
  if (!text) return failAs(text);
  if (Result<void> written = writeFileAtomically(options.output, *text); !written) return written;
  report(fmt::format("written: {} ({} features, {} vertices from {}; edges bow by up to {:.3f} m)", options.output,
                     warped->features.size(), warped->vertices_after, warped->vertices_before,
                     warped->largest_sagitta_m));
  return {};
}

Result<void> exportWaypoints(const ExportOptions& options) {
  const Result<Projector> projector = loadProjector(options.projector);
  if (!projector) return failAs(projector);
  const Result<WarpedFeatures> warped = warpedFeatures(*projector, options);
  if (!warped) return failAs(warped);
  const Result<std::string> text = formatNav2Waypoints(warped->features);
  if (!text) return fail(text.error().code, text.error().message, options.features);
  if (Result<void> written = writeFileAtomically(options.output, *text); !written) return written;
  report("written: " + options.output);
  return {};
}

Result<void> exportRmf(const ExportOptions& options) {
  const Result<Projector> projector = loadProjector(options.projector);
  if (!projector) return failAs(projector);
  FeatureList features;
  if (!options.features.empty()) {
    Result<FeatureList> read = readFeatures(options.features);
    if (!read) return failAs(read);
    features = std::move(*read);
  }
  const Result<LevelTransform> fit = fitLevelTransform(*projector, features, options.spacing_m, options.references);
  if (!fit) return failAs(fit);
  if (Result<void> written = writeFileAtomically(options.output, formatRmfTransform(*fit, options.level)); !written) {
    return written;
  }
  report(fmt::format("written: {} (a similarity leaves {:.3f} m rms, {:.3f} m at most, at {} places)", options.output,
                     fit->rms_m, fit->max_m, fit->places));
  return {};
}

Result<void> exportTinshift(const ExportOptions& options) {
  const Result<Projector> projector = loadProjector(options.projector);
  if (!projector) return failAs(projector);
  const Result<TriangleMesh> mesh = triangulate(*projector, options.vertices);
  if (!mesh) return fail(mesh.error().code, mesh.error().message, options.projector);
  const std::string name = std::filesystem::path(options.projector).stem().string();
  if (Result<void> written = writeFileAtomically(options.output, formatTinshift(*mesh, name)); !written) {
    return written;
  }
  report(fmt::format("written: {} ({} vertices, {} triangles of {:.3g} m; up to {:.3f} m from the projector)",
                     options.output, mesh->vertices.size(), mesh->triangles.size(), mesh->edge_m,
                     mesh->max_deviation_m));
  return {};
}

Result<void> exportG2o(const ExportOptions& options) {
  const Result<ProjectorData> data = readProjectorFile(options.projector);
  if (!data) return failAs(data);
  if (Result<void> written = writeFileAtomically(options.output, formatG2o(*data)); !written) return written;
  report(fmt::format("written: {} ({} nodes, {} edges, {} anchors)", options.output, data->node_slam.size(),
                     data->edges.size(), data->anchors.size()));
  return {};
}

Result<void> exportGrid(const ExportOptions& options) {
  const Result<Projector> projector = loadProjector(options.projector);
  if (!projector) return failAs(projector);
  const Result<PoseGrid> grid = sampleGrid(*projector, options.direction, options.step_m);
  if (!grid) return failAs(grid);
  const std::filesystem::path npy = options.output;
  const std::filesystem::path json = std::filesystem::path(npy).replace_extension(".json");
  if (npy == json) {
    return fail(ErrorCode::kOutOfDomain, "is the name of the description beside the grid; end it in .npy",
                npy.string());
  }
  const bool to_slam = options.direction == WarpDirection::kToSlam;
  if (Result<void> written = writeFileAtomically(npy, formatNpy(*grid)); !written) return written;
  const std::string description = formatGridDescription(*grid, npy.filename().string(), to_slam ? "blueprint" : "slam",
                                                        to_slam ? "slam" : "blueprint");
  if (Result<void> written = writeFileAtomically(json, description); !written) return written;
  report(fmt::format("written: {} and {} ({} x {} samples; bilinear is up to {:.4f} m from the projector)",
                     npy.string(), json.string(), grid->columns, grid->rows, grid->max_deviation_m));
  return {};
}

using Run = Result<void> (*)(const ExportOptions&);

/// One subcommand of `export` with the options that all of them have.
CLI::App* addExport(CLI::App& parent, ActionSlot& chosen, const std::shared_ptr<ExportOptions>& options,
                    const char* name, const char* what, Run run) {
  CLI::App* command = parent.add_subcommand(name, what);
  command->add_option("projector", options->projector, "Projector file (.c2s)")->required();
  command->add_option("-o,--output", options->output, "File to write")->required();
  command->callback([options, &chosen, run] { chosen.set([options, run] { return run(*options); }); });
  return command;
}

void addWarping(CLI::App& command, ExportOptions& options) {
  command.add_option("features", options.features, "GeoJSON or CSV, metres")->required();
  command.add_option("--chord-error", options.chord_error_m, "How far bent edges may lie from what is written [m]")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  addOutside(command, options.outside);
}

}  // namespace

void addExportCommand(CLI::App& app, ActionSlot& chosen) {
  CLI::App* parent = app.add_subcommand("export", "Write what robots and fleet managers read");
  parent->require_subcommand(1);
  const auto options = std::make_shared<ExportOptions>();

  CLI::App* features =
      addExport(*parent, chosen, options, "features",
                "Points, paths and polygons in the other frame: GeoJSON, or CSV by the extension", exportFeatures);
  addWarping(*features, *options);
  addDirection(*features, options->direction, "Frame of what is written");
  addMaskExports(*parent, chosen);
  CLI::App* waypoints = addExport(*parent, chosen, options, "waypoints",
                                  "Points of the blueprint as waypoints of nav2's RViz panel", exportWaypoints);
  addWarping(*waypoints, *options);

  CLI::App* rmf = addExport(*parent, chosen, options, "rmf",
                            "The nearest similarity for a fleet adapter of Open-RMF, with what it leaves", exportRmf);
  rmf->add_option("features", options->features, "Lanes and waypoints that matter (default: the whole mesh)");
  rmf->add_option("--level", options->level, "Name of the level in Open-RMF")->capture_default_str();
  rmf->add_option("--spacing", options->spacing_m, "Distance of the places on a path [m]")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  rmf->add_option("--references", options->references, "How many reference coordinates")->capture_default_str();

  CLI::App* tinshift = addExport(*parent, chosen, options, "tinshift",
                                 "Triangles for PROJ (+proj=tinshift), pyproj, QGIS and GDAL", exportTinshift);
  tinshift->add_option("--vertices", options->vertices, "At most so many")->capture_default_str();
  addExport(*parent, chosen, options, "g2o", "The solved graph for solvers", exportG2o);
  CLI::App* grid = addExport(*parent, chosen, options, "grid",
                             "A regular grid as .npy, with a .json beside it, for bilinear interpolation", exportGrid);
  addDirection(*grid, options->direction, "Frame of what is written");
  grid->add_option("--step", options->step_m, "Distance of the samples [m]")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
}

}  // namespace cad2slam::cli
