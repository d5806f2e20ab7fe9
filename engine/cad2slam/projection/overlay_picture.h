// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>

#include <vector>

#include "cad2slam/core/result.h"
#include "cad2slam/map/occupancy_grid.h"
#include "cad2slam/projection/projector.h"

namespace cad2slam {

/// Draws the warped walls of a blueprint over a SLAM map in two inks: blueprint magenta, SLAM map green, dark where
/// they agree. CV_8UC3 (BGR), in the SLAM frame, as large as the SLAM map but at most `largest_side_px`. `anchors` are
/// drawn as circles at their SLAM points [m], with a line to where the projector puts them.
struct OverlayAnchor {
  Eigen::Vector2d in_blueprint = Eigen::Vector2d::Zero();  ///< [m]
  Eigen::Vector2d in_slam = Eigen::Vector2d::Zero();       ///< [m]
};
[[nodiscard]] Result<cv::Mat> drawOverlay(const Projector& projector, const OccupancyGrid& blueprint,
                                          const OccupancyGrid& slam, const std::vector<OverlayAnchor>& anchors,
                                          int largest_side_px = 3000);

/// The states of `grid` warped pixel by pixel into `target_frame`; unknown where the mesh does not reach. Pools the
/// source first where its pixels are smaller than the target's, so that thin walls survive.
[[nodiscard]] Result<OccupancyGrid> warpGrid(const Projector& projector, bool to_slam, const OccupancyGrid& grid,
                                             const MapFrame& target_frame);

/// The picture map_server's saver writes: 254 free, 0 occupied, 205 unknown.
[[nodiscard]] cv::Mat trinaryPicture(const OccupancyGrid& grid);

}  // namespace cad2slam
