// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cad2slam/anchors/anchor.h"
#include "cad2slam/core/result.h"
#include "cad2slam/io/map_file.h"
#include "cad2slam/solver/solver_settings.h"

namespace cad2slam {

/// Numbers that a project can hold; with others it could not be saved. See also kResolutionRange.
inline constexpr NumberRange kCellSizeRange{1e-6, 1e6};  ///< [m]
inline constexpr NumberRange kFixedScaleRange{1e-6, 1e6};
inline constexpr NumberRange kWeightRange{0.0, 1e12};  ///< of the solver's settings

/// One raster of a project: where its YAML or image lies and how to recognise it.
struct ProjectRaster {
  MapMetadata metadata;  ///< paths absolute in memory, relative to the project file on disk where possible
  std::uintmax_t image_bytes = 0;
  std::string image_sha256;  ///< empty: not yet known
};

/// The first half of an anchor whose counterpart was not clicked yet.
struct PendingAnchor {
  bool in_blueprint = true;  ///< which frame the point is in
  double x_m = 0.0;
  double y_m = 0.0;

  friend bool operator==(const PendingAnchor&, const PendingAnchor&) = default;
};

/// One robot's SLAM map with its own anchors.
struct ProjectSlamMap {
  std::string name;  ///< unique in the project, not empty
  ProjectRaster raster;
  AnchorList anchors;
  std::optional<PendingAnchor> pending;
};

/// Content of a `.c2sproj` file (DESIGN.md section 5).
struct Project {
  std::string name;
  ProjectRaster blueprint;
  std::vector<ProjectSlamMap> slam_maps;
  SolverSettings settings;
  std::optional<double> cell_size_m;     ///< empty: automatic
  std::string view_state_json = "{}";    ///< an object that only the app understands
  std::string app_version;               ///< that wrote it
  std::string unknown_keys_json = "{}";  ///< the document as read, so that keys of newer versions survive a save
};

inline constexpr int kProjectFormatVersion = 1;

/// kMalformed names the JSON key; a newer major version is refused. Images are not opened: a missing or changed image
/// is the caller's to find with checkRaster().
[[nodiscard]] Result<Project> parseProject(const std::string& text, const std::filesystem::path& path);
[[nodiscard]] Result<Project> readProject(const std::filesystem::path& path);

/// The same project gives the same bytes. Paths below the project's folder are written relative to it.
[[nodiscard]] std::string formatProject(const Project& project, const std::filesystem::path& path);
[[nodiscard]] Result<void> writeProject(const std::filesystem::path& path, const Project& project);

/// Fills size and hash of a raster from the image on disk.
[[nodiscard]] Result<ProjectRaster> describeRaster(const MapMetadata& metadata);

enum class RasterState { kUnchanged, kMissing, kChanged };
[[nodiscard]] RasterState checkRaster(const ProjectRaster& raster);

}  // namespace cad2slam
