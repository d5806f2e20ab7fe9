// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>

#include "cad2slam/core/result.h"
#include "cad2slam/map/map_frame.h"
#include "cad2slam/projection/projector.h"

namespace cad2slam {

/// Resampling of whole rasters through a projector: the projector is evaluated on a coarse grid of the output (refined
/// until its interpolation error is below a quarter pixel, beyond the mesh down to four pixels) and the pixels follow
/// with cv::remap.
enum class WarpDirection {
  kToSlam,       ///< a picture in the blueprint frame is drawn in the SLAM frame
  kToBlueprint,  ///< a picture in the SLAM frame is drawn in the blueprint frame
};

struct WarpOptions {
  cv::Scalar outside_value = cv::Scalar::all(205);  ///< of output pixels the mesh does not reach; 205 = unknown
  double reach_m = -1.0;  ///< how far beyond the mesh pixels are still drawn (walls!); < 0: one and a half cells
  bool smooth = true;     ///< bilinear; false: nearest neighbour, for occupancy values that must not be mixed
};

/// Draws `source` (any 8 or 16 bit type, 1 to 4 channels, with `source_frame`) into the raster described by
/// `target_frame`. kOutOfDomain: the frames do not fit the images.
[[nodiscard]] Result<cv::Mat> warpRaster(const Projector& projector, WarpDirection direction, const cv::Mat& source,
                                         const MapFrame& source_frame, const MapFrame& target_frame,
                                         const WarpOptions& options = {});

/// The smallest upright frame of the target side that holds everything the projector can draw, at
/// `resolution_m_per_px`.
[[nodiscard]] Result<MapFrame> warpedExtent(const Projector& projector, WarpDirection direction,
                                            const MapFrame& source_frame, double resolution_m_per_px);

}  // namespace cad2slam
