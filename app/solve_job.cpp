// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "app/solve_job.h"

#include <chrono>
#include <cstdlib>
#include <ctime>
#include <utility>

#include "cad2slam/anchors/anchor_checks.h"
#include "cad2slam/io/anchors_csv.h"
#include "cad2slam/io/project_file.h"
#include "cad2slam/io/sha256.h"
#include "cad2slam/io/text.h"
#include "cad2slam/mesh/mesh_builder.h"

namespace cad2slam::cli {
namespace {

double secondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

Result<FrameInfo> describeFrame(const MapMetadata& metadata, const std::string& name) {
  const Result<MapFrame> frame = readMapFrame(metadata);
  if (!frame) return failAs(frame);
  Result<std::string> digest = sha256HexOfFile(metadata.image);
  if (!digest) return failAs(digest);
  FrameInfo info;
  info.name = name;
  info.image_sha256 = std::move(*digest);
  info.resolution_m_per_px = frame->resolution();
  info.width_px = frame->width();
  info.height_px = frame->height();
  info.metric_from_corner = frame->metricFromCorner();
  return info;
}

Result<MapFrame> frameOf(const FrameInfo& info) {
  return MapFrame::create(info.resolution_m_per_px, info.width_px, info.height_px, info.metric_from_corner);
}

std::string mapName(const MapMetadata& metadata) {
  return (metadata.yaml.empty() ? metadata.image : metadata.yaml).stem().string();
}

}  // namespace

Result<SolveInputs> inputsFromFiles(const std::filesystem::path& blueprint, const std::filesystem::path& slam,
                                    const std::filesystem::path& anchors) {
  SolveInputs inputs;
  Result<MapYaml> blueprint_yaml = readMapYaml(blueprint);
  if (!blueprint_yaml) return failAs(blueprint_yaml);
  Result<MapYaml> slam_yaml = readMapYaml(slam);
  if (!slam_yaml) return failAs(slam_yaml);
  Result<AnchorImport> read = readAnchors(anchors);
  if (!read) return failAs(read);
  inputs.blueprint = std::move(blueprint_yaml->metadata);
  inputs.slam = std::move(slam_yaml->metadata);
  inputs.slam_name = mapName(inputs.slam);
  inputs.anchors = std::move(read->anchors);
  const auto tell = [&inputs](const std::filesystem::path& file, const std::vector<std::string>& warnings) {
    for (const std::string& warning : warnings) inputs.warnings.push_back(file.string() + ": " + warning);
  };
  tell(blueprint, blueprint_yaml->warnings);
  tell(slam, slam_yaml->warnings);
  for (const RejectedLine& line : read->rejected) {
    inputs.warnings.push_back(anchors.string() + ":" + std::to_string(line.line) + ": line skipped: " + line.reason +
                              ".");
  }
  return inputs;
}

Result<SolveInputs> inputsFromProject(const std::filesystem::path& path, const std::string& map) {
  Result<Project> project = readProject(path);
  if (!project) return failAs(project);
  std::string names;
  for (ProjectSlamMap& slam : project->slam_maps) {
    names += (names.empty() ? "" : ", ") + slam.name;
    if (!map.empty() ? slam.name != map : project->slam_maps.size() != 1) continue;
    SolveInputs inputs;
    inputs.blueprint = project->blueprint.metadata;
    inputs.slam = slam.raster.metadata;
    inputs.slam_name = slam.name;
    inputs.project = path.filename().string();
    inputs.anchors = std::move(slam.anchors);
    inputs.settings = project->settings;
    inputs.cell_size_m = project->cell_size_m;
    for (const auto& [raster, name] :
         {std::pair{&project->blueprint, "blueprint"}, std::pair{&slam.raster, "SLAM map"}}) {
      if (checkRaster(*raster) == RasterState::kChanged) {
        inputs.warnings.push_back(std::string("The image of the ") + name +
                                  " is not the one the project was made with.");
      }
    }
    return inputs;
  }
  if (project->slam_maps.empty()) return fail(ErrorCode::kDegenerate, "the project has no SLAM map", path.string());
  return fail(ErrorCode::kNotFound,
              map.empty() ? "the project has several SLAM maps; choose one with --map: " + names
                          : "the project has no SLAM map named " + map + "; it has: " + names,
              path.string());
}

Result<double> positiveNumber(const std::string& text, const std::string& option) {
  const std::optional<double> value = parseNumber(text);
  if (!value || !(*value > 0.0))
    return fail(ErrorCode::kOutOfDomain, "'" + text + "' is not a positive number", option);
  return *value;
}

Result<void> applyScaleAndCells(const std::string& scale, const std::string& cell_size, SolveInputs& inputs) {
  if (scale == "auto") {
    inputs.settings.scale.rule = ScaleRule::kToScale;
  } else if (scale == "unknown") {
    inputs.settings.scale.rule = ScaleRule::kLeastSquares;
  } else if (!scale.empty()) {
    const Result<double> fixed = positiveNumber(scale, "--scale");
    if (!fixed) return failAs(fixed);
    inputs.settings.scale = {ScaleRule::kFixed, *fixed};
  }
  if (cell_size == "auto") {
    inputs.cell_size_m.reset();
  } else if (!cell_size.empty()) {
    const Result<double> metres = positiveNumber(cell_size, "--cell-size");
    if (!metres) return failAs(metres);
    inputs.cell_size_m = *metres;
  }
  return {};
}

Result<SolvedJob> runSolve(const SolveInputs& inputs, SolverBackend backend, const IterationCallback& on_iteration) {
  SolvedJob job;
  job.warnings = inputs.warnings;
  auto start = std::chrono::steady_clock::now();
  Result<FrameInfo> blueprint = describeFrame(inputs.blueprint, mapName(inputs.blueprint));
  if (!blueprint) return failAs(blueprint);
  Result<FrameInfo> slam = describeFrame(inputs.slam, inputs.slam_name);
  if (!slam) return failAs(slam);
  job.blueprint = std::move(*blueprint);
  job.slam = std::move(*slam);
  const Result<MapFrame> slam_frame = frameOf(job.slam);
  const Result<MapFrame> blueprint_frame = frameOf(job.blueprint);
  if (!slam_frame) return failAs(slam_frame);
  if (!blueprint_frame) return failAs(blueprint_frame);
  if (Result<void> usable = checkAnchors(inputs.anchors, {*blueprint_frame, *slam_frame}); !usable)
    return failAs(usable);
  const Result<LoadedMap> map = loadMap(inputs.blueprint, {inputs.semantics});
  if (!map) return failAs(map);
  job.warnings.insert(job.warnings.end(), map->warnings.begin(), map->warnings.end());
  job.seconds.load = secondsSince(start);

  start = std::chrono::steady_clock::now();
  Result<Mesh> mesh = buildMesh(map->grid, inputs.cell_size_m);
  if (!mesh) return fail(mesh.error().code, mesh.error().message, inputs.blueprint.image.string());
  job.mesh = std::make_shared<const Mesh>(std::move(*mesh));
  job.seconds.mesh = secondsSince(start);

  start = std::chrono::steady_clock::now();
  Result<Solution> solution =
      MeshSolver(job.mesh, backend).solve(inputs.anchors, inputs.settings, nullptr, on_iteration);
  if (!solution) return failAs(solution);
  job.solution = std::move(*solution);
  job.seconds.solve = secondsSince(start);
  job.warnings.insert(job.warnings.end(), job.solution.warnings.begin(), job.solution.warnings.end());
  return job;
}

std::string creationTime() {
  std::time_t time = std::time(nullptr);
  if (const char* epoch = std::getenv("SOURCE_DATE_EPOCH"); epoch != nullptr) {
    time = static_cast<std::time_t>(std::strtoll(epoch, nullptr, 10));
  }
  std::tm utc{};
  gmtime_r(&time, &utc);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc);
  return text;
}

}  // namespace cad2slam::cli
