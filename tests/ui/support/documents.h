// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cad2slam/io/project_file.h"
#include "ui/document/project_document.h"

#include <string>

namespace cad2slam::test {

/// A project with a blueprint and one SLAM map named "robot 1", whose images do not exist.
inline Project smallProject() {
  Project project;
  project.name = "site";
  project.blueprint.metadata.image = "/nowhere/blueprint.png";
  project.blueprint.metadata.metric_from_corner = Pose2{{-3.0, 2.0}, 0.0};
  ProjectSlamMap map;
  map.name = "robot 1";
  map.raster.metadata.image = "/nowhere/slam.png";
  project.slam_maps.push_back(map);
  return project;
}

/// All that undo has to restore, as text: equal texts are equal to the last bit.
inline std::string fingerprint(const ProjectDocument& document) {
  Project project = document.projectToSave();
  for (ProjectSlamMap& map : project.slam_maps) map.pending.reset();
  return formatProject(project, "/nowhere/site.c2sproj");
}

}  // namespace cad2slam::test
