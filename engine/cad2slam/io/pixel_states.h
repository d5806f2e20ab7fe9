// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include <opencv2/core/mat.hpp>

#include "cad2slam/core/result.h"
#include "cad2slam/io/map_file.h"

namespace cad2slam {

/// How a map_server reads the pixels of one image.
struct PixelRules {
  MapSemantics semantics = MapSemantics::kJazzy;
  MapMode mode = MapMode::kTrinary;
  double occupied_threshold = 0.65;
  double free_threshold = 0.196;
  bool negate = false;
  std::uint32_t full_brightness = 0;  ///< sample value of white; 0: the largest of the type
};

/// A raster of CellState and what was noticed while it was made.
struct PixelStates {
  cv::Mat states;                    ///< CV_8UC1 of CellState values
  std::size_t read_differently = 0;  ///< pixels that the other MapSemantics puts into another state
  bool grey_205_is_free = false;     ///< map_saver's value of unknown is there, and counts as free
};

/// Classifies every pixel of `picture` (CV_8U or CV_16U; 1, 3 or 4 channels in OpenCV's order). A value between the
/// thresholds is unknown in every mode: scale and raw maps grade how occupied a pixel is, and a graded pixel is neither
/// free nor occupied. An 8-bit grey picture that nobody else holds is overwritten in place.
/// kMalformed: another pixel type.
[[nodiscard]] Result<PixelStates> classifyPixels(cv::Mat picture, const PixelRules& rules);

}  // namespace cad2slam
