// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/document/project_commands.h"

#include "ui/convert.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <utility>

namespace cad2slam {

EditProjectCommand::EditProjectCommand(ProjectDocument& document, DocumentState after, Changes what,
                                       const QString& text, std::string current_map)
    : QUndoCommand(text),
      document_(document),
      before_(document.state()),
      after_(std::move(after)),
      what_(what),
      map_before_(document.currentMapName()),
      map_after_(current_map.empty() ? map_before_ : std::move(current_map)) {}

/// What was found out of the images of a state since it was kept.
void EditProjectCommand::learn(DocumentState& state) const {
  const Project& now = document_.project();
  describeLike(state.project.blueprint, now.blueprint);
  for (ProjectSlamMap& map : state.project.slam_maps) {
    for (const ProjectSlamMap& each : now.slam_maps)
      if (each.name == map.name) describeLike(map.raster, each.raster);
  }
}

void EditProjectCommand::redo() {
  learn(before_);
  ChangeEvent event;
  event.what = what_;
  event.by_history = !first_time_;
  first_time_ = false;
  document_.applyState(after_, map_after_, event);
}

void EditProjectCommand::undo() {
  learn(after_);
  ChangeEvent event;
  event.what = what_;
  event.by_history = true;
  document_.applyState(before_, map_before_, event);
}

namespace edit {
namespace {

QString text(const char* source) {
  return QCoreApplication::translate("edit", source);
}

bool hasMap(const Project& project, const std::string& name) {
  return std::any_of(project.slam_maps.begin(), project.slam_maps.end(),
                     [&](const ProjectSlamMap& map) { return map.name == name; });
}

std::string freeName(const Project& project, const std::string& wanted) {
  const std::string base = wanted.empty() ? toStd(text(QT_TRANSLATE_NOOP("edit", "SLAM map"))) : wanted;
  std::string name = base;
  for (int number = 2; hasMap(project, name); ++number) name = base + " " + std::to_string(number);
  return name;
}

}  // namespace

void setBlueprint(ProjectDocument& document, const ProjectRaster& raster) {
  DocumentState state = document.state();
  state.project.blueprint = raster;
  document.undoStack().push(new EditProjectCommand(document, std::move(state), Change::kBlueprint,
                                                   text(QT_TRANSLATE_NOOP("edit", "choose blueprint"))));
}

void rescaleBlueprint(ProjectDocument& document, double factor) {
  if (!document.mayEditAnchors()) return;
  if (!std::isfinite(factor) || factor <= 0.0 || factor == 1.0) return;
  if (!kResolutionRange.holds(document.project().blueprint.metadata.resolution_m_per_px * factor)) return;
  DocumentState state = document.state();
  MapMetadata& metadata = state.project.blueprint.metadata;
  metadata.resolution_m_per_px *= factor;
  metadata.metric_from_corner.translation *= factor;
  for (ProjectSlamMap& map : state.project.slam_maps)
    for (Anchor& anchor : map.anchors) anchor.in_blueprint *= factor;
  document.undoStack().push(new EditProjectCommand(document, std::move(state), Change::kBlueprint,
                                                   text(QT_TRANSLATE_NOOP("edit", "rescale blueprint"))));
}

void flipBlueprint(ProjectDocument& document, const MapFrame& frame) {
  if (!document.mayEditAnchors()) return;
  DocumentState state = document.state();
  MapMetadata& metadata = state.project.blueprint.metadata;
  metadata.mirrored = !metadata.mirrored;
  for (ProjectSlamMap& map : state.project.slam_maps) {
    for (Anchor& anchor : map.anchors) {
      Eigen::Vector2d pixel = frame.pixelFromMetric(anchor.in_blueprint);
      pixel.x() = frame.width() - pixel.x();
      anchor.in_blueprint = frame.metricFromPixel(pixel);
    }
  }
  document.undoStack().push(new EditProjectCommand(document, std::move(state), Change::kBlueprint,
                                                   text(QT_TRANSLATE_NOOP("edit", "mirror blueprint"))));
}

void changeSettings(ProjectDocument& document, const ProjectSettings& settings) {
  DocumentState state = document.state();
  Changes what;
  if (state.project.settings != settings.solver || state.project.cell_size_m != settings.cell_size_m)
    what |= Change::kSettings;
  if (!(state.limits == settings.limits)) what |= Change::kPreferences;
  if (!what) return;
  state.project.settings = settings.solver;
  state.project.cell_size_m = settings.cell_size_m;
  state.limits = settings.limits;
  document.undoStack().push(
      new EditProjectCommand(document, std::move(state), what, text(QT_TRANSLATE_NOOP("edit", "change settings"))));
}

std::string addSlamMap(ProjectDocument& document, const std::string& name, const ProjectRaster& raster) {
  DocumentState state = document.state();
  ProjectSlamMap map;
  map.name = freeName(state.project, name);
  map.raster = raster;
  const std::string given = map.name;
  state.project.slam_maps.push_back(std::move(map));
  document.undoStack().push(new EditProjectCommand(document, std::move(state), Change::kSlamMaps | Change::kCurrentMap,
                                                   text(QT_TRANSLATE_NOOP("edit", "add SLAM map")), given));
  return given;
}

void removeSlamMap(ProjectDocument& document, const std::string& name) {
  if (!document.mayEditAnchors()) return;  // they would go with it
  if (!hasMap(document.project(), name)) return;
  DocumentState state = document.state();
  std::erase_if(state.project.slam_maps, [&](const ProjectSlamMap& map) { return map.name == name; });
  state.snapped.erase(name);
  document.undoStack().push(new EditProjectCommand(document, std::move(state), Change::kSlamMaps | Change::kCurrentMap,
                                                   text(QT_TRANSLATE_NOOP("edit", "remove SLAM map"))));
}

bool renameSlamMap(ProjectDocument& document, const std::string& name, const std::string& new_name) {
  if (new_name.empty() || !hasMap(document.project(), name)) return false;
  if (name == new_name) return true;
  if (hasMap(document.project(), new_name)) return false;
  DocumentState state = document.state();
  for (ProjectSlamMap& map : state.project.slam_maps)
    if (map.name == name) map.name = new_name;
  if (auto snapped = state.snapped.extract(name)) {
    snapped.key() = new_name;
    state.snapped.insert(std::move(snapped));
  }
  const std::string current = document.currentMapName() == name ? new_name : document.currentMapName();
  document.undoStack().push(new EditProjectCommand(document, std::move(state), Change::kSlamMaps,
                                                   text(QT_TRANSLATE_NOOP("edit", "rename SLAM map")), current));
  return true;
}

void setSlamRaster(ProjectDocument& document, const std::string& name, const ProjectRaster& raster) {
  DocumentState state = document.state();
  for (ProjectSlamMap& map : state.project.slam_maps)
    if (map.name == name) map.raster = raster;
  document.undoStack().push(new EditProjectCommand(document, std::move(state), Change::kSlamMaps,
                                                   text(QT_TRANSLATE_NOOP("edit", "choose SLAM map"))));
}

}  // namespace edit
}  // namespace cad2slam
