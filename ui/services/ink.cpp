// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/services/ink.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <opencv2/core/hal/intrin.hpp>
#include <opencv2/core/utility.hpp>
#include <opencv2/imgproc.hpp>

namespace cad2slam {
namespace {

/// Grey values from which on a raster takes no ink: just below the grey of its unknown or outer ground where it has one
/// (found as the most frequent mid grey), else near white.
double paperFrom(TileStore& tiles) {
  constexpr double kNearWhite = 235.0;
  constexpr double kLeastPart = 0.06;  // of the raster that must be of one mid grey
  const int last = tiles.levels() - 1;
  const cv::Size size = tiles.levelSize(last);
  const cv::Mat coarse = tiles.region(last, cv::Rect(cv::Point(0, 0), size), kPaper);
  if (coarse.empty()) return kNearWhite;
  std::array<int, 256> counts{};
  const cv::Mat grey = greyOf(coarse);
  for (int row = 0; row < grey.rows; ++row) {
    for (int column = 0; column < grey.cols; ++column) ++counts[grey.at<uchar>(row, column)];
  }
  const auto most = std::max_element(counts.begin() + 60, counts.begin() + 245);
  if (*most < kLeastPart * static_cast<double>(grey.total())) return kNearWhite;
  return static_cast<double>(most - counts.begin()) - 10.0;
}

/// Half the size, rounded up; of four pixels the darkest.
cv::Mat darkestOfFour(const cv::Mat& grey) {
  cv::Mat half((grey.rows + 1) / 2, (grey.cols + 1) / 2, CV_8UC1);
  for (int row = 0; row < half.rows; ++row) {
    const uchar* upper = grey.ptr(2 * row);
    const uchar* lower = grey.ptr(std::min(2 * row + 1, grey.rows - 1));
    uchar* out = half.ptr(row);
    const int pairs = grey.cols / 2;
    int x = 0;
    for (constexpr int kAtOnce = cv::v_uint8x16::nlanes; x + kAtOnce <= pairs; x += kAtOnce) {
      cv::v_uint8x16 upper_left, upper_right, lower_left, lower_right;
      cv::v_load_deinterleave(upper + 2 * x, upper_left, upper_right);
      cv::v_load_deinterleave(lower + 2 * x, lower_left, lower_right);
      cv::v_store(out + x, cv::v_min(cv::v_min(upper_left, upper_right), cv::v_min(lower_left, lower_right)));
    }
    for (; x < pairs; ++x) {
      const uchar left = std::min(upper[2 * x], lower[2 * x]);
      const uchar right = std::min(upper[2 * x + 1], lower[2 * x + 1]);
      out[x] = std::min(left, right);
    }
    if (pairs < half.cols) out[pairs] = std::min(upper[grey.cols - 1], lower[grey.cols - 1]);
  }
  return half;
}

}  // namespace

Inking inkingOf(TileStore& tiles) {
  constexpr double kFullInk = 20.0;
  const double paper_from = paperFrom(tiles);
  Inking inking(1, 256, CV_8UC1);
  for (int grey = 0; grey < inking.cols; ++grey) {
    const double amount = (paper_from - grey) / (paper_from - kFullInk);
    inking.at<uchar>(grey) = static_cast<uchar>(std::lround(255.0 * (1.0 - std::clamp(amount, 0.0, 1.0))));
  }
  return inking;
}

cv::Mat inkRegion(TileStore& tiles, int level, const cv::Rect& rect, const Inking& inking) {
  constexpr int kFiner = 2;                  // levels; tells apart what is mixed in the next two
  constexpr double kMostPixels = 8'000'000;  // that are looked at for one picture
  int finer = 0;
  while (finer < std::min(kFiner, level) && static_cast<double>(rect.area()) * (4 << 2 * finer) <= kMostPixels) ++finer;
  const cv::Rect fine = cv::Rect(rect.x << finer, rect.y << finer, rect.width << finer, rect.height << finer) &
                        cv::Rect(cv::Point(0, 0), tiles.levelSize(level - finer));
  cv::Mat ink(rect.size(), CV_8UC1, cv::Scalar(kPaper));
  // Tile by tile, which begin on whole pixels of the coarser level: all of it at once would not stay in the cache.
  constexpr int kTile = RasterSource::kTileSize;
  const cv::Range rows(fine.y / kTile, (fine.br().y - 1) / kTile + 1);
  const cv::Range columns(fine.x / kTile, (fine.br().x - 1) / kTile + 1);
  cv::parallel_for_(cv::Range(0, rows.size() * columns.size()), [&](const cv::Range& range) {
    for (int i = range.start; i < range.end; ++i) {
      const int row = rows.start + i / columns.size();
      const int column = columns.start + i % columns.size();
      const cv::Mat tile = tiles.get({level - finer, column, row});
      if (tile.empty()) continue;
      const cv::Point corner(column * kTile, row * kTile);
      const cv::Rect part = fine & cv::Rect(corner, tile.size());
      cv::Mat grey = greyOf(tile(part - corner));
      // The darker takes more ink, and how much is looked up later.
      for (int halvings = 0; halvings < finer; ++halvings) grey = darkestOfFour(grey);
      const cv::Point to((part.x >> finer) - rect.x, (part.y >> finer) - rect.y);
      cv::LUT(grey, inking, ink(cv::Rect(to, grey.size())));
    }
  });
  return ink;
}

cv::Mat greyOf(const cv::Mat& pixels) {
  if (pixels.channels() == 1) return pixels;
  cv::Mat grey;
  cv::cvtColor(pixels, grey, cv::COLOR_BGRA2GRAY);
  return grey;
}

}  // namespace cad2slam
