// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/services/pyramid_builder.h"

#include <algorithm>

namespace cad2slam {
namespace {

constexpr int kTile = RasterSource::kTileSize;

template <int kChannels>
void halveRows(const uchar* upper, const uchar* lower, uchar* out, int source_width) {
  const int pairs = source_width / 2;
  for (int x = 0; x < pairs; ++x) {
    for (int c = 0; c < kChannels; ++c) {
      const int a = upper[2 * x * kChannels + c];
      const int b = upper[(2 * x + 1) * kChannels + c];
      const int d = lower[2 * x * kChannels + c];
      const int e = lower[(2 * x + 1) * kChannels + c];
      const int darkest = std::min(std::min(a, b), std::min(d, e));
      out[x * kChannels + c] = static_cast<uchar>((a + b + d + e + 4 * darkest + 4) / 8);
    }
  }
  if (source_width % 2 != 0) {
    for (int c = 0; c < kChannels; ++c) {
      const int a = upper[(source_width - 1) * kChannels + c];
      const int b = lower[(source_width - 1) * kChannels + c];
      out[pairs * kChannels + c] = static_cast<uchar>((a + b + 2 * std::min(a, b) + 2) / 4);
    }
  }
}

}  // namespace

PyramidBuilder::PyramidBuilder(std::shared_ptr<TileStore> store) : store_(std::move(store)) {
  levels_.resize(static_cast<std::size_t>(store_->levels()));
}

int PyramidBuilder::levelCount(QSize size) {
  int count = 1;
  for (int side = std::max(size.width(), size.height()); side > kTile; side = (side + 1) / 2) ++count;
  return count;
}

cv::Mat PyramidBuilder::halved(const cv::Mat& pixels) {
  cv::Mat out((pixels.rows + 1) / 2, (pixels.cols + 1) / 2, pixels.type());
  for (int row = 0; row < out.rows; ++row) {
    const uchar* upper = pixels.ptr(2 * row);
    const uchar* lower = pixels.ptr(std::min(2 * row + 1, pixels.rows - 1));
    if (pixels.channels() == 1) {
      halveRows<1>(upper, lower, out.ptr(row), pixels.cols);
    } else {
      halveRows<4>(upper, lower, out.ptr(row), pixels.cols);
    }
  }
  return out;
}

bool PyramidBuilder::append(const cv::Mat& rows) {
  return appendTo(0, rows);
}

bool PyramidBuilder::appendTo(int level, const cv::Mat& rows) {
  Level& here = levels_[static_cast<std::size_t>(level)];
  for (int done = 0; done < rows.rows;) {
    if (here.strip.empty()) here.strip.create(kTile, rows.cols, rows.type());
    const int count = std::min(rows.rows - done, kTile - here.filled);
    rows.rowRange(done, done + count).copyTo(here.strip.rowRange(here.filled, here.filled + count));
    here.filled += count;
    done += count;
    if (here.filled == kTile && !flush(level)) return false;
  }
  return true;
}

bool PyramidBuilder::flush(int level) {
  Level& here = levels_[static_cast<std::size_t>(level)];
  if (here.filled == 0) return true;
  const cv::Mat strip = here.strip.rowRange(0, here.filled);
  for (int column = 0; column * kTile < strip.cols; ++column) {
    const int right = std::min(strip.cols, (column + 1) * kTile);
    if (!store_->put({level, column, here.next_row}, strip.colRange(column * kTile, right))) return false;
  }
  ++here.next_row;
  here.filled = 0;
  return level + 1 >= store_->levels() || appendTo(level + 1, halved(strip));
}

bool PyramidBuilder::finish() {
  for (int level = 0; level < store_->levels(); ++level) {
    if (!flush(level)) return false;
    levels_[static_cast<std::size_t>(level)].strip.release();
  }
  return true;
}

}  // namespace cad2slam
