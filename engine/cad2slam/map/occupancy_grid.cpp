// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/map/occupancy_grid.h"

#include <opencv2/core.hpp>

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <utility>

namespace cad2slam {
namespace {

constexpr int kTile = OccupancyGrid::kTileSize;
constexpr int kWordPixels = 32;
constexpr std::uint64_t kLowBits = 0x5555555555555555U;  // the lower one of every pixel's two
constexpr auto kFree = static_cast<std::uint8_t>(CellState::kFree);
constexpr auto kOccupied = static_cast<std::uint8_t>(CellState::kOccupied);
constexpr auto kUnknown = static_cast<std::uint8_t>(CellState::kUnknown);

int tilesFor(int pixels) {
  return (pixels + kTile - 1) / kTile;
}

bool isOfOneState(const cv::Mat& tile) {
  const std::uint8_t* top = tile.ptr<std::uint8_t>(0);
  const auto width = static_cast<std::size_t>(tile.cols);
  if (std::memcmp(top, top + 1, width - 1) != 0) return false;
  for (int row = 1; row < tile.rows; ++row) {
    if (std::memcmp(top, tile.ptr<std::uint8_t>(row), width) != 0) return false;
  }
  return true;
}

std::uint64_t packed(const std::uint8_t* states, int count) {
  std::uint64_t word = 0;
  for (int k = 0; k < count; ++k) word |= static_cast<std::uint64_t>(states[k] & 3U) << (2 * k);
  return word;
}

/// The lower bit of every pixel that is free, of the pixels from `first` to before `last` of a word.
std::uint64_t freeBits(std::uint64_t word, int first, int last) {
  const std::uint64_t is_free = ~(word | word >> 1) & kLowBits;
  const std::uint64_t up_to_last = last >= kWordPixels ? ~std::uint64_t{0} : (std::uint64_t{1} << (2 * last)) - 1;
  return is_free & up_to_last & ~((std::uint64_t{1} << (2 * first)) - 1);
}

}  // namespace

OccupancyGrid::OccupancyGrid(const MapFrame& frame, const cv::Mat& states) : frame_(frame) {
  if (states.type() != CV_8UC1 || states.cols != frame_.width() || states.rows != frame_.height()) {
    throw std::invalid_argument("OccupancyGrid: the states do not fit the frame");
  }
  OccupancyGridBuilder builder(frame);
  builder.append(states);
  tiles_ = builder.build().tiles_;
}

CellState OccupancyGrid::at(const Eigen::Vector2d& point_m) const {
  const Eigen::Vector2d pixel = frame_.pixelFromMetric(point_m);
  // Compared as doubles: a far-away or non-finite point must not be cast to int.
  const bool inside = pixel.x() >= 0.0 && pixel.y() >= 0.0 && pixel.x() < frame_.width() && pixel.y() < frame_.height();
  return inside ? at(static_cast<int>(pixel.x()), static_cast<int>(pixel.y())) : CellState::kUnknown;
}

cv::Mat OccupancyGrid::states(const cv::Rect& piece) const {
  cv::Mat out(piece.height, piece.width, CV_8UC1);
  for (int y = 0; y < piece.height; ++y) {
    const int row = piece.y + y;
    std::uint8_t* to = out.ptr<std::uint8_t>(y);
    for (int x = 0; x < piece.width;) {
      const int column = piece.x + x;
      const std::uint32_t tile = tiles_->tile(column / kTile, row / kTile);
      if (tile < Tiles::kMixed) {
        const int count = std::min(kTile - column % kTile, piece.width - x);
        std::fill_n(to + x, count, static_cast<std::uint8_t>(tile));
        x += count;
        continue;
      }
      const int count = std::min(kWordPixels - column % kWordPixels, piece.width - x);
      std::uint64_t word =
          tiles_
              ->mixed[tile - Tiles::kMixed][static_cast<std::size_t>(row % kTile * 2 + column % kTile / kWordPixels)] >>
          (2 * (column % kWordPixels));
      for (int k = 0; k < count; ++k, word >>= 2) to[x + k] = static_cast<std::uint8_t>(word & 3U);
      x += count;
    }
  }
  return out;
}

bool OccupancyGrid::holdsFree(const cv::Rect& piece) const {
  const int right = piece.x + piece.width;
  const int bottom = piece.y + piece.height;
  for (int top = piece.y; top < bottom;) {
    const int next_top = std::min(bottom, (top / kTile + 1) * kTile);
    for (int left = piece.x; left < right;) {
      const int next_left = std::min(right, (left / kWordPixels + 1) * kWordPixels);
      const std::uint32_t tile = tiles_->tile(left / kTile, top / kTile);
      if (tile == kFree) return true;
      if (tile >= Tiles::kMixed) {
        const MixedTile& mixed = tiles_->mixed[tile - Tiles::kMixed];
        const int first = left % kWordPixels;
        for (int row = top; row < next_top; ++row) {
          const std::uint64_t word = mixed[static_cast<std::size_t>(row % kTile * 2 + left % kTile / kWordPixels)];
          if (freeBits(word, first, first + next_left - left) != 0) return true;
        }
      }
      left = next_left;
    }
    top = next_top;
  }
  return false;
}

std::size_t OccupancyGrid::memory() const {
  return tiles_->index.capacity() * sizeof(std::uint32_t) + tiles_->mixed.capacity() * sizeof(MixedTile);
}

OccupancyGridBuilder::OccupancyGridBuilder(const MapFrame& frame)
    : frame_(frame), tiles_(std::make_shared<OccupancyGrid::Tiles>()) {
  tiles_->columns = tilesFor(frame.width());
  tiles_->index.reserve(static_cast<std::size_t>(tiles_->columns) * static_cast<std::size_t>(tilesFor(frame.height())));
}

void OccupancyGridBuilder::append(const cv::Mat& states) {
  if (states.type() != CV_8UC1 || states.cols != frame_.width() || states.rows > frame_.height() - rows_done_) {
    throw std::invalid_argument("OccupancyGridBuilder: the rows do not fit the frame");
  }
  for (int taken = 0; taken < states.rows;) {
    const int count = std::min(kTile - rows_waiting_, states.rows - taken);
    const cv::Mat rows = states.rowRange(taken, taken + count);
    taken += count;
    rows_done_ += count;
    const bool is_last = rows_done_ == frame_.height();
    if (rows_waiting_ == 0 && (count == kTile || is_last)) {
      packBand(rows);
      continue;
    }
    if (band_.empty()) band_.create(kTile, frame_.width(), CV_8UC1);
    rows.copyTo(band_.rowRange(rows_waiting_, rows_waiting_ + count));
    rows_waiting_ += count;
    if (rows_waiting_ == kTile || is_last) {
      packBand(band_.rowRange(0, rows_waiting_));
      rows_waiting_ = 0;
    }
  }
}

void OccupancyGridBuilder::packBand(const cv::Mat& band) {
  for (int left = 0; left < band.cols; left += kTile) {
    const cv::Mat tile = band.colRange(left, std::min(band.cols, left + kTile));
    if (isOfOneState(tile)) {
      const std::uint8_t state = tile.at<std::uint8_t>(0, 0);
      if (state == kFree) tiles_->free_pixels += tile.total();
      tiles_->index.push_back(state);
      continue;
    }
    OccupancyGrid::MixedTile mixed{};
    for (int row = 0; row < tile.rows; ++row) {
      const std::uint8_t* states = tile.ptr<std::uint8_t>(row);
      tiles_->free_pixels += static_cast<std::size_t>(std::count(states, states + tile.cols, kFree));
      for (int word = 0; word * kWordPixels < tile.cols; ++word) {
        mixed[static_cast<std::size_t>(2 * row + word)] =
            packed(states + word * kWordPixels, std::min(kWordPixels, tile.cols - word * kWordPixels));
      }
    }
    tiles_->index.push_back(OccupancyGrid::Tiles::kMixed + static_cast<std::uint32_t>(tiles_->mixed.size()));
    tiles_->mixed.push_back(mixed);
  }
}

OccupancyGrid OccupancyGridBuilder::build() {
  if (rows_done_ < frame_.height()) {
    const int rows_left = std::min(kTile, frame_.height() - rows_done_);
    const cv::Mat unknown(rows_left, frame_.width(), CV_8UC1, cv::Scalar(kUnknown));
    while (rows_done_ < frame_.height()) append(unknown.rowRange(0, std::min(rows_left, frame_.height() - rows_done_)));
  }
  tiles_->mixed.shrink_to_fit();
  return {frame_, std::exchange(tiles_, nullptr)};
}

Result<OccupancyGrid> pooled(const OccupancyGrid& grid, int factor) {
  if (factor <= 1) return grid;
  const MapFrame& frame = grid.frame();
  const int width = (frame.width() + factor - 1) / factor;
  const int height = (frame.height() + factor - 1) / factor;
  // Rows count from the top, so a last row that is not full reaches below the bottom edge.
  const double resolution = frame.resolution() * factor;
  const Eigen::Vector2d corner = frame.metricFromPixel({0.0, static_cast<double>(height) * factor});
  const Result<MapFrame> pooled_frame =
      MapFrame::create(resolution, width, height, {corner, frame.metricFromCorner().heading});
  if (!pooled_frame) return failAs(pooled_frame);
  OccupancyGridBuilder builder(*pooled_frame);
  for (int top = 0; top < frame.height(); top += factor) {
    const cv::Mat band = grid.states({0, top, frame.width(), std::min(factor, frame.height() - top)});
    cv::Mat line(1, width, CV_8UC1, cv::Scalar(kFree));
    std::uint8_t* to = line.ptr<std::uint8_t>(0);
    for (int row = 0; row < band.rows; ++row) {
      const std::uint8_t* from = band.ptr<std::uint8_t>(row);
      for (int column = 0; column < band.cols; ++column) {
        std::uint8_t& state = to[column / factor];
        if (from[column] == kOccupied || state == kOccupied) {
          state = kOccupied;
        } else if (from[column] == kUnknown) {
          state = kUnknown;
        }
      }
    }
    builder.append(line);
  }
  return builder.build();
}

}  // namespace cad2slam
