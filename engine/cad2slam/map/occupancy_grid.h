// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "cad2slam/map/map_frame.h"

namespace cad2slam {

/// What map_server says of one pixel.
enum class CellState : std::uint8_t { kFree = 0, kOccupied = 1, kUnknown = 2 };

/// A raster of free, occupied and unknown pixels with its metric frame. Copies share the pixels, which are never
/// written after construction.
///
/// Memory: pixels lie in square tiles, of which one of a single state takes 4 bytes and any other two bits a pixel, so
/// that a blueprint of 30 000 x 30 000 pixels takes some ten MB and never more than 226.
class OccupancyGrid {
 public:
  static constexpr int kTileSize = 64;  ///< [px]

  /// `states`: CV_8UC1 of CellState values, as large as the frame; anything else is a broken contract.
  OccupancyGrid(const MapFrame& frame, const cv::Mat& states);

  [[nodiscard]] const MapFrame& frame() const { return frame_; }
  /// The same pixels in another frame for a raster of the same size.
  [[nodiscard]] OccupancyGrid withFrame(const MapFrame& frame) const { return {frame, tiles_}; }

  /// Outside the raster everything is unknown.
  [[nodiscard]] CellState at(int column, int row) const {
    if (column < 0 || row < 0 || column >= frame_.width() || row >= frame_.height()) return CellState::kUnknown;
    return tiles_->at(column, row);
  }
  [[nodiscard]] CellState at(const Eigen::Vector2d& point_m) const;

  /// The states of a piece, which must lie inside the raster, as CV_8UC1 of CellState values. Unpacked on each call.
  [[nodiscard]] cv::Mat states(const cv::Rect& piece) const;
  /// All of them: one byte a pixel, so not for rasters of any size.
  [[nodiscard]] cv::Mat states() const { return states({0, 0, frame_.width(), frame_.height()}); }

  /// Whether there is a free pixel in a piece, which must lie inside the raster.
  [[nodiscard]] bool holdsFree(const cv::Rect& piece) const;
  [[nodiscard]] std::size_t freePixels() const { return tiles_->free_pixels; }
  /// [byte] of the pixels.
  [[nodiscard]] std::size_t memory() const;

 private:
  friend class OccupancyGridBuilder;

  /// A row of a tile is two words, the state of its leftmost pixel in the lowest two bits of the first.
  using MixedTile = std::array<std::uint64_t, 2 * kTileSize>;
  struct Tiles {
    static constexpr std::uint32_t kMixed = 3;  // from here on the index of a mixed tile
    int columns = 0;
    std::vector<std::uint32_t> index;  // row by row: a state, or kMixed + place in `mixed`
    std::vector<MixedTile> mixed;
    std::size_t free_pixels = 0;

    [[nodiscard]] std::uint32_t tile(int column, int row) const {
      return index[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                   static_cast<std::size_t>(column)];
    }
    [[nodiscard]] CellState at(int column, int row) const {
      const std::uint32_t found = tile(column / kTileSize, row / kTileSize);
      if (found < kMixed) return static_cast<CellState>(found);
      const int x = column % kTileSize;
      const std::uint64_t word = mixed[found - kMixed][static_cast<std::size_t>(row % kTileSize * 2 + x / 32)];
      return static_cast<CellState>(word >> (2 * (x % 32)) & 3U);
    }
  };

  OccupancyGrid(const MapFrame& frame, std::shared_ptr<const Tiles> tiles) : frame_(frame), tiles_(std::move(tiles)) {}

  MapFrame frame_;
  std::shared_ptr<const Tiles> tiles_;
};

/// Makes a grid from rows that come piece by piece, so that the raster never lies in memory unpacked.
class OccupancyGridBuilder {
 public:
  explicit OccupancyGridBuilder(const MapFrame& frame);

  /// The next rows from the top: CV_8UC1 of CellState values as wide as the frame. Anything else, or more rows than the
  /// frame has, is a broken contract.
  void append(const cv::Mat& states);
  /// Rows that were not appended are unknown. Leaves the builder empty.
  [[nodiscard]] OccupancyGrid build();

 private:
  void packBand(const cv::Mat& band);

  MapFrame frame_;
  std::shared_ptr<OccupancyGrid::Tiles> tiles_;
  cv::Mat band_;  // rows that wait for a full row of tiles
  int rows_waiting_ = 0;
  int rows_done_ = 0;
};

/// A grid with every `factor` x `factor` pixels made one: occupied wins over unknown, unknown over free, so that no
/// wall is lost. kMalformed: no frame can be so coarse.
[[nodiscard]] Result<OccupancyGrid> pooled(const OccupancyGrid& grid, int factor);

}  // namespace cad2slam
