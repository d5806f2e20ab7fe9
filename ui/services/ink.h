// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>

#include "ui/services/tile_store.h"

namespace cad2slam {

inline constexpr int kPaper = 255;  ///< grey of what is not loaded or not drawn

/// For each grey value how much ink it takes: black for all, white for none. 1 x 256 bytes.
using Inking = cv::Mat;

/// Of a raster: its ground takes none.
[[nodiscard]] Inking inkingOf(TileStore& tiles);

/// A piece of a level as ink. Walls of one pixel between white and grey are lost in the mean of a few levels, being as
/// grey as the ground; so what is ink is seen on finer pixels, and the ink is made smaller.
[[nodiscard]] cv::Mat inkRegion(TileStore& tiles, int level, const cv::Rect& rect, const Inking& inking);

/// One channel, whatever the tiles have.
[[nodiscard]] cv::Mat greyOf(const cv::Mat& pixels);

}  // namespace cad2slam
