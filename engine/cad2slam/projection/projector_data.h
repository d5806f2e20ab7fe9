// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cad2slam/geometry/pose2.h"
#include "cad2slam/mesh/tile_lattice.h"

namespace cad2slam {

/// How the predictions of the nodes near a query are blended.
enum class BlendWeights {
  kSmooth,  ///< quadratic B-spline of the tile lattice, renormalised over existing nodes: C1, support 1.5 cells
  kPaper,   ///< 1 / (distance + 1e-3) over all nodes within `radius_m` (the paper's eq. 1, 2); jumps at the radius
};

/// What a query outside the mesh gives.
enum class OutsidePolicy {
  kError,  ///< no pose
  kRigid,  ///< the nearest place of the mesh predicts as a rigid (and stretched) body
};

/// Which raster a frame belongs to.
struct FrameInfo {
  std::string name;          ///< of the map, as the installer calls it
  std::string image_sha256;  ///< lower-case hex of the image file, or empty
  double resolution_m_per_px = 0.0;
  int width_px = 0;
  int height_px = 0;
  Pose2 metric_from_corner;  ///< `origin:` of the YAML
};

/// What was known of the quality when the projector was made; metres.
struct QualityInfo {
  double anchor_rms_m = 0.0;
  double anchor_max_m = 0.0;
  double leave_one_out_mean_m = 0.0;
  double leave_one_out_median_m = 0.0;
  double leave_one_out_max_m = 0.0;
  std::size_t anchors_used = 0;
  std::size_t folded_tiles = 0;
};

/// Everything of a projector that is not an array.
struct ProjectorInfo {
  std::string model = "stretch";  ///< "stretch" or "rigid"
  double scale = 1.0;             ///< SLAM metres per blueprint metre of the rest lengths
  BlendWeights weights = BlendWeights::kSmooth;
  double radius_m = 4.0;  ///< used with kPaper
  OutsidePolicy outside = OutsidePolicy::kError;
  TileLattice lattice;
  FrameInfo blueprint;
  FrameInfo slam;
  QualityInfo quality;
  std::string creator;  ///< program and version
  std::string created;  ///< ISO 8601 UTC, or empty in reproducible files
  std::string project;  ///< name of the project file, or empty
  std::string note;     ///< e.g. the warnings that were overridden at export
};

/// One pose known in both frames, kept in the file so that a reader can prove itself.
struct CheckPose {
  Pose2 in_blueprint;
  Pose2 in_slam;
};

/// The whole content of a projector file (DESIGN.md section 5) as a value.
struct ProjectorData {
  ProjectorInfo info;
  std::vector<Eigen::Vector2d> node_blueprint;  ///< [m]
  std::vector<Pose2> node_slam;                 ///< slam_from_node, metres and radians
  std::vector<Eigen::Vector2d> node_stretch;    ///< log-stretch along the node's axes
  std::vector<TileCoordinate> node_tile;
  std::vector<std::array<std::uint32_t, 2>> edges;
  std::vector<std::array<double, 4>> anchors;  ///< blueprint x, y, SLAM x, y [m]
  std::vector<CheckPose> check_poses;
};

}  // namespace cad2slam
