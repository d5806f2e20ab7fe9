// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>

#include <cstdint>
#include <vector>

#include "cad2slam/core/result.h"
#include "cad2slam/exports/feature.h"
#include "cad2slam/map/map_frame.h"

namespace cad2slam {

/// A zone in the frame of the mask.
struct MaskZone {
  std::vector<PointList> rings;  ///< of one polygon: its border, then its holes
  std::vector<PointList> lines;  ///< open lines, part of the zone as far as the buffer reaches
  double buffer_m = 0.0;         ///< safety distance around polygons; half the width of lines
};

/// CV_8UC1, as large as the frame: 255 at each pixel whose square the enlarged zone touches, else 0. Never leaves a
/// touched pixel out; takes in nothing that is farther from the zone than the buffer and 1.7 pixels.
/// kOutOfDomain: a place that is not finite, a negative buffer.
[[nodiscard]] Result<cv::Mat> touchedPixels(const MapFrame& frame, const MaskZone& zone);

/// The other way round: 255 only at pixels that lie wholly on polygons made smaller by the buffer, or wholly within the
/// buffer of a line. Never takes in a pixel that does not.
[[nodiscard]] Result<cv::Mat> coveredPixels(const MapFrame& frame, const MaskZone& zone);

/// The mask of nav2's KeepoutFilter as map_server's picture: 0 (occupied) in the zones, 254 (free) elsewhere.
/// `invert`: the zones are where the robot may be, and all else is occupied.
[[nodiscard]] Result<cv::Mat> keepoutMask(const MapFrame& frame, const std::vector<MaskZone>& zones, bool invert);

struct SpeedZone {
  MaskZone zone;
  double percent = 100.0;  ///< of the largest speed, 1 to 100
};

/// The mask of nav2's SpeedFilter for map_server's scale mode with thresholds 0 and 1 (base 0, multiplier 1): value
/// `percent` in the zones, where zones overlap the lower one; 0, which means no limit, elsewhere.
[[nodiscard]] Result<cv::Mat> speedMask(const MapFrame& frame, const std::vector<SpeedZone>& zones);

/// Grey value that map_server reads as `percent` in scale mode with thresholds 0 and 1.
[[nodiscard]] std::uint8_t greyOfPercent(double percent);

}  // namespace cad2slam
