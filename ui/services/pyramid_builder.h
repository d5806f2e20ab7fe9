// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>

#include <memory>
#include <vector>

#include "ui/services/tile_store.h"

namespace cad2slam {

/// Cuts a raster that comes in strips from the top into tiles of all levels. Memory: two strips of 256 rows for each
/// level.
class PyramidBuilder {
 public:
  explicit PyramidBuilder(std::shared_ptr<TileStore> store);

  /// Rows of level 0, in the store's number of channels. False when the store has no room left.
  [[nodiscard]] bool append(const cv::Mat& rows);
  /// After the last row.
  [[nodiscard]] bool finish();

  /// Half the size, rounded up. The mean of four pixels mixed with the darkest of them: walls that are one pixel wide
  /// stay visible when a whole floor is in view.
  [[nodiscard]] static cv::Mat halved(const cv::Mat& pixels);
  /// Levels until a raster fits into one tile.
  [[nodiscard]] static int levelCount(QSize size);

 private:
  struct Level {
    cv::Mat strip;  // up to kTileSize rows that wait to be cut
    int filled = 0;
    int next_row = 0;  // of tiles
  };
  [[nodiscard]] bool appendTo(int level, const cv::Mat& rows);
  [[nodiscard]] bool flush(int level);

  std::shared_ptr<TileStore> store_;
  std::vector<Level> levels_;
};

}  // namespace cad2slam
