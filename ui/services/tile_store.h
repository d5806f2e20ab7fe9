// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QTemporaryFile>

#include <opencv2/core/mat.hpp>

#include <cstdint>
#include <list>
#include <memory>
#include <mutex>
#include <unordered_map>
#include <vector>

#include "ui/views/raster_source.h"

namespace cad2slam {

/// Keeps the tiles of one raster in little memory, for any thread.
///
/// Tiles are packed with zstd (maps shrink to a few per cent; a tile of one value to nothing). Packed tiles beyond
/// kPackedBytes go to a temporary file, and at most unpackedLimit() bytes of unpacked tiles are kept, least recently
/// used first out. Together that is the cap on what a raster of any size takes: 64 MiB packed + 24 MiB unpacked for a
/// grey one, 64 + 96 for a coloured one.
class TileStore {
 public:
  static constexpr std::size_t kPackedBytes = std::size_t{64} << 20;
  static constexpr std::size_t kUnpackedBytesPerChannel = std::size_t{24} << 20;

  /// `channels`: 1 or 4.
  TileStore(QSize size, int levels, int channels);

  [[nodiscard]] QSize size() const { return size_; }
  [[nodiscard]] int levels() const { return levels_; }
  [[nodiscard]] int channels() const { return channels_; }

  /// False when the tile could not be kept: no room for the temporary file.
  [[nodiscard]] bool put(const TileKey& key, const cv::Mat& pixels);
  [[nodiscard]] bool has(const TileKey& key) const;
  /// The tile if it is at hand unpacked, else empty. Shares the pixels: not to be written.
  [[nodiscard]] cv::Mat peek(const TileKey& key);
  /// Unpacks when needed; empty while the tile was not put yet.
  [[nodiscard]] cv::Mat get(const TileKey& key);
  /// A piece of a level, clipped to it; pixels of tiles that are not there yet get `missing`. Empty outside the level.
  [[nodiscard]] cv::Mat region(int level, const cv::Rect& rect, int missing, bool* complete = nullptr);

  /// Whether the image can have transparent pixels, which its tiles show over white. Noted before others see the store.
  void noteTransparency() { transparent_ = true; }
  [[nodiscard]] bool hadTransparency() const { return transparent_; }
  [[nodiscard]] std::size_t packedBytes() const;
  [[nodiscard]] std::size_t unpackedBytes() const;
  [[nodiscard]] std::size_t spilledBytes() const;
  [[nodiscard]] std::size_t unpackedLimit() const { return kUnpackedBytesPerChannel * channels_; }
  [[nodiscard]] cv::Size levelSize(int level) const;

 private:
  using Code = std::uint64_t;
  struct Packed {
    std::vector<char> bytes;   // empty when spilled or of one value
    std::int64_t offset = -1;  // in the spill file
    std::uint32_t length = 0;  // of the packed bytes in the spill file
    bool uniform = false;
    std::uint32_t value = 0;  // of every pixel
    cv::Size size;
  };
  struct Unpacked {
    cv::Mat pixels;
    std::list<Code>::iterator used;
  };

  static Code codeOf(const TileKey& key);
  cv::Mat unpack(const Packed& packed, std::vector<char> bytes) const;
  void keepUnpacked(Code code, const cv::Mat& pixels);

  const QSize size_;
  const int levels_;
  const int channels_;
  mutable std::mutex mutex_;
  std::unordered_map<Code, Packed> packed_;
  std::unordered_map<Code, Unpacked> unpacked_;
  std::list<Code> recent_;  // most recently used first
  std::size_t packed_bytes_ = 0;
  std::size_t unpacked_bytes_ = 0;
  std::unique_ptr<QTemporaryFile> spill_;
  std::int64_t spill_end_ = 0;
  bool transparent_ = false;
};

}  // namespace cad2slam
