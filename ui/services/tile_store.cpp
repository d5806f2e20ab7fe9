// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/services/tile_store.h"

#include <algorithm>
#include <cstring>

#include <zstd.h>

namespace cad2slam {
namespace {

constexpr int kTile = RasterSource::kTileSize;

/// Whether every pixel is the same, and which.
bool isUniform(const cv::Mat& pixels, std::uint32_t* value) {
  const std::size_t pixel_bytes = pixels.elemSize();
  const std::size_t row_bytes = pixel_bytes * static_cast<std::size_t>(pixels.cols);
  const uchar* first = pixels.ptr(0);
  // A row is uniform when it equals itself shifted by one pixel.
  if (row_bytes > pixel_bytes && std::memcmp(first, first + pixel_bytes, row_bytes - pixel_bytes) != 0) return false;
  for (int row = 1; row < pixels.rows; ++row) {
    if (std::memcmp(first, pixels.ptr(row), row_bytes) != 0) return false;
  }
  *value = 0;
  std::memcpy(value, first, pixel_bytes);
  return true;
}

}  // namespace

TileStore::TileStore(QSize size, int levels, int channels) : size_(size), levels_(levels), channels_(channels) {}

TileStore::Code TileStore::codeOf(const TileKey& key) {
  return (static_cast<Code>(key.level) << 56) | (static_cast<Code>(static_cast<std::uint32_t>(key.row)) << 28) |
         static_cast<Code>(static_cast<std::uint32_t>(key.column));
}

cv::Size TileStore::levelSize(int level) const {
  const int round_up = (1 << level) - 1;
  return {(size_.width() + round_up) >> level, (size_.height() + round_up) >> level};
}

bool TileStore::put(const TileKey& key, const cv::Mat& pixels) {
  Packed packed;
  packed.size = pixels.size();
  packed.uniform = isUniform(pixels, &packed.value);
  if (!packed.uniform) {
    const cv::Mat dense = pixels.isContinuous() ? pixels : pixels.clone();
    const std::size_t bytes = dense.total() * dense.elemSize();
    packed.bytes.resize(ZSTD_compressBound(bytes));
    const std::size_t length = ZSTD_compress(packed.bytes.data(), packed.bytes.size(), dense.data, bytes, 1);
    if (ZSTD_isError(length)) return false;
    packed.bytes.resize(length);
    packed.bytes.shrink_to_fit();
  }
  const std::lock_guard lock(mutex_);
  if (packed_bytes_ + packed.bytes.size() > kPackedBytes) {
    if (!spill_) {
      spill_ = std::make_unique<QTemporaryFile>();
      if (!spill_->open()) return false;
    }
    const auto length = static_cast<qint64>(packed.bytes.size());
    if (!spill_->seek(spill_end_) || spill_->write(packed.bytes.data(), length) != length) return false;
    packed.offset = spill_end_;
    packed.length = static_cast<std::uint32_t>(length);
    spill_end_ += length;
    packed.bytes = {};
  }
  packed_bytes_ += packed.bytes.size();
  packed_.insert_or_assign(codeOf(key), std::move(packed));
  return true;
}

bool TileStore::has(const TileKey& key) const {
  const std::lock_guard lock(mutex_);
  return packed_.count(codeOf(key)) != 0;
}

cv::Mat TileStore::peek(const TileKey& key) {
  const std::lock_guard lock(mutex_);
  const auto found = unpacked_.find(codeOf(key));
  if (found == unpacked_.end()) return {};
  recent_.splice(recent_.begin(), recent_, found->second.used);
  return found->second.pixels;
}

cv::Mat TileStore::unpack(const Packed& packed, std::vector<char> bytes) const {
  cv::Mat pixels(packed.size, channels_ == 1 ? CV_8UC1 : CV_8UC4);
  if (packed.uniform) {
    uchar value[4];
    std::memcpy(value, &packed.value, sizeof value);
    pixels.setTo(channels_ == 1 ? cv::Scalar(value[0]) : cv::Scalar(value[0], value[1], value[2], value[3]));
    return pixels;
  }
  const std::size_t size = pixels.total() * pixels.elemSize();
  const std::size_t length = ZSTD_decompress(pixels.data, size, bytes.data(), bytes.size());
  if (ZSTD_isError(length) || length != size) return {};  // the temporary file was damaged
  return pixels;
}

cv::Mat TileStore::get(const TileKey& key) {
  const Code code = codeOf(key);
  Packed packed;
  std::vector<char> bytes;
  {
    const std::lock_guard lock(mutex_);
    const auto ready = unpacked_.find(code);
    if (ready != unpacked_.end()) {
      recent_.splice(recent_.begin(), recent_, ready->second.used);
      return ready->second.pixels;
    }
    const auto found = packed_.find(code);
    if (found == packed_.end()) return {};
    packed = found->second;
    if (packed.offset >= 0) {
      bytes.resize(packed.length);
      if (!spill_->seek(packed.offset) || spill_->read(bytes.data(), packed.length) != packed.length) return {};
    } else {
      bytes = std::move(packed.bytes);
    }
  }
  cv::Mat pixels = unpack(packed, std::move(bytes));
  if (!pixels.empty()) keepUnpacked(code, pixels);
  return pixels;
}

void TileStore::keepUnpacked(Code code, const cv::Mat& pixels) {
  const std::lock_guard lock(mutex_);
  if (unpacked_.count(code) != 0) return;
  recent_.push_front(code);
  unpacked_.emplace(code, Unpacked{pixels, recent_.begin()});
  unpacked_bytes_ += pixels.total() * pixels.elemSize();
  while (unpacked_bytes_ > unpackedLimit() && recent_.size() > 1) {
    const auto oldest = unpacked_.find(recent_.back());
    unpacked_bytes_ -= oldest->second.pixels.total() * oldest->second.pixels.elemSize();
    unpacked_.erase(oldest);
    recent_.pop_back();
  }
}

cv::Mat TileStore::region(int level, const cv::Rect& rect, int missing, bool* complete) {
  if (complete != nullptr) *complete = true;
  if (level < 0 || level >= levels_) return {};
  const cv::Rect wanted = rect & cv::Rect(cv::Point(0, 0), levelSize(level));
  if (wanted.empty()) return {};
  cv::Mat out(wanted.size(), channels_ == 1 ? CV_8UC1 : CV_8UC4);
  for (int row = wanted.y / kTile; row <= (wanted.br().y - 1) / kTile; ++row) {
    for (int column = wanted.x / kTile; column <= (wanted.br().x - 1) / kTile; ++column) {
      const cv::Rect part = wanted & cv::Rect(column * kTile, row * kTile, kTile, kTile);
      cv::Mat target = out(part - wanted.tl());
      const cv::Mat tile = get({level, column, row});
      if (tile.empty()) {
        target.setTo(cv::Scalar::all(missing));
        if (complete != nullptr) *complete = false;
      } else {
        tile(part - cv::Point(column * kTile, row * kTile)).copyTo(target);
      }
    }
  }
  return out;
}

std::size_t TileStore::packedBytes() const {
  const std::lock_guard lock(mutex_);
  return packed_bytes_;
}
std::size_t TileStore::unpackedBytes() const {
  const std::lock_guard lock(mutex_);
  return unpacked_bytes_;
}
std::size_t TileStore::spilledBytes() const {
  const std::lock_guard lock(mutex_);
  return static_cast<std::size_t>(spill_end_);
}

}  // namespace cad2slam
