// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cad2slam/map/map_frame.h"
#include "cad2slam/solver/solver_settings.h"
#include "ui/document/project_document.h"

#include <QUndoCommand>

#include <optional>
#include <string>
#include <vector>

namespace cad2slam {

/// A rare edit of more than anchors, kept as the whole state before and after: undo is exact by construction, and a
/// project without its pixels is small.
class EditProjectCommand : public QUndoCommand {
 public:
  EditProjectCommand(ProjectDocument& document, DocumentState after, Changes what, const QString& text,
                     std::string current_map = {});

  void redo() override;
  void undo() override;

 private:
  void learn(DocumentState& state) const;

  ProjectDocument& document_;
  DocumentState before_;
  DocumentState after_;
  Changes what_;
  std::string map_before_;
  std::string map_after_;
  bool first_time_ = true;
};

/// Settings a dialog edits together.
struct ProjectSettings {
  SolverSettings solver;
  std::optional<double> cell_size_m;
  ClassLimits limits;
};

namespace edit {

/// Another image as blueprint; anchors keep their metres.
void setBlueprint(ProjectDocument& document, const ProjectRaster& raster);
/// `factor` times as many metres for each pixel; anchors stay on their pixels. Nothing happens where a project could
/// not hold the resolution.
void rescaleBlueprint(ProjectDocument& document, double factor);
/// Mirrors the picture left to right; anchors stay on their pixels. `frame`: of the blueprint.
void flipBlueprint(ProjectDocument& document, const MapFrame& frame);
void changeSettings(ProjectDocument& document, const ProjectSettings& settings);

/// Adds a SLAM map and goes to it. A name that is empty or taken gets a number. Returns the name it got.
std::string addSlamMap(ProjectDocument& document, const std::string& name, const ProjectRaster& raster);
void removeSlamMap(ProjectDocument& document, const std::string& name);
/// False, and nothing happens, where the new name is empty or taken.
bool renameSlamMap(ProjectDocument& document, const std::string& name, const std::string& new_name);
/// The same map in another file; anchors keep their metres.
void setSlamRaster(ProjectDocument& document, const std::string& name, const ProjectRaster& raster);

}  // namespace edit
}  // namespace cad2slam
