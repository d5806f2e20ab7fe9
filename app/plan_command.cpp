// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/cli_command.h"
#include "cad2slam/io/map_file.h"
#include "cad2slam/io/projector_file.h"
#include "cad2slam/planning/grid_planner.h"

namespace cad2slam::cli {
namespace {

struct PlanOptions {
  std::string blueprint;
  std::string projector;
  std::vector<double> start;
  std::vector<double> goal;
  PlannerSettings planner;
  bool json = false;
};

/// A pose of the path on the blueprint and, with a projector, in the SLAM map.
struct PathPose {
  Pose2 in_blueprint;
  std::optional<Projection> in_slam;
};

void printCsv(const std::vector<PathPose>& poses) {
  std::string text;
  for (const PathPose& pose : poses) {
    text += fmt::format("{:.9f},{:.9f},{:.9f}", pose.in_blueprint.translation.x(), pose.in_blueprint.translation.y(),
                        pose.in_blueprint.heading);
    if (pose.in_slam) {
      const Pose2& slam = pose.in_slam->pose;
      text += fmt::format(",{:.9f},{:.9f},{:.9f}", slam.translation.x(), slam.translation.y(), slam.heading);
    }
    text += '\n';
  }
  std::cout << text;
}

void printJson(const PlannedPath& path, const std::vector<PathPose>& poses) {
  nlohmann::ordered_json blueprint = nlohmann::ordered_json::array();
  nlohmann::ordered_json slam = nlohmann::ordered_json::array();
  for (const PathPose& pose : poses) {
    const auto as_array = [](const Pose2& p) {
      return nlohmann::ordered_json{p.translation.x(), p.translation.y(), p.heading};
    };
    blueprint.push_back(as_array(pose.in_blueprint));
    if (pose.in_slam) slam.push_back(as_array(pose.in_slam->pose));
  }
  nlohmann::ordered_json json = {{"length_m", path.length_m}, {"blueprint", std::move(blueprint)}};
  if (!slam.empty()) json["slam"] = std::move(slam);
  std::cout << json.dump(2) << '\n';
}

Result<void> plan(const PlanOptions& options) {
  const Result<LoadedMap> map = loadMap(options.blueprint);
  if (!map) return failAs(map);
  std::optional<Projector> projector;
  if (!options.projector.empty()) {
    Result<Projector> loaded = loadProjector(options.projector);
    if (!loaded) return failAs(loaded);
    projector = std::move(*loaded);
  }
  const Result<PlannedPath> path =
      planPath(map->grid, {options.start[0], options.start[1]}, {options.goal[0], options.goal[1]}, options.planner);
  if (!path) return failAs(path);
  std::vector<PathPose> poses;
  for (const Pose2& pose : path->poses) {
    PathPose both{pose, {}};
    if (projector) {
      both.in_slam = projector->slamFromBlueprint(pose, OutsidePolicy::kError);
      if (!both.in_slam->ok()) {
        return fail(
            ErrorCode::kOutOfDomain,
            fmt::format("the path leaves the mesh at ({:.2f}, {:.2f})", pose.translation.x(), pose.translation.y()),
            options.projector);
      }
    }
    poses.push_back(both);
  }
  if (options.json) {
    printJson(*path, poses);
  } else {
    printCsv(poses);
  }
  return {};
}

}  // namespace

void addPlanCommand(CLI::App& app, ActionSlot& chosen) {
  auto options = std::make_shared<PlanOptions>();
  CLI::App* command = app.add_subcommand("plan", "Find a path on a blueprint, and where it runs in the SLAM map");
  command->add_option("blueprint", options->blueprint, "Map to plan on (map_server YAML)")->required();
  command->add_option("--start", options->start, "x,y in metres")->required()->delimiter(',')->expected(2);
  command->add_option("--goal", options->goal, "x,y in metres")->required()->delimiter(',')->expected(2);
  command->add_option("--projector", options->projector, "Projector file (.c2s): adds x,y,theta in the SLAM map");
  command->add_option("--radius", options->planner.robot_radius_m, "Radius of the robot in metres")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  command->add_option("--clearance", options->planner.wanted_clearance_m, "Wanted distance to walls in metres")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  command->add_option("--step", options->planner.step_m, "Metres between poses")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command->add_flag("--json", options->json, "Print one JSON object instead of CSV lines");
  command->callback([options, &chosen] { chosen.set([options] { return plan(*options); }); });
}

}  // namespace cad2slam::cli
