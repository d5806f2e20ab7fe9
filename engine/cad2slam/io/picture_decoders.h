// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <utility>

#include "cad2slam/io/image_header.h"
#include "cad2slam/io/picture_rows.h"

namespace cad2slam {

// Each for files that readImageHeader() found to be of its format; null for a kind that is better decoded in one piece.
[[nodiscard]] std::unique_ptr<PictureRows> openPngRows(const std::filesystem::path& image);
[[nodiscard]] std::unique_ptr<PictureRows> openJpegRows(const std::filesystem::path& image);
[[nodiscard]] std::unique_ptr<PictureRows> openTiffRows(const std::filesystem::path& image);
[[nodiscard]] std::unique_ptr<PictureRows> openPnmRows(const std::filesystem::path& image, const ImageHeader& header);

/// Rows whose start() succeeded, or null.
template <class Rows>
[[nodiscard]] std::unique_ptr<PictureRows> startedRows(const std::filesystem::path& image) {
  auto rows = std::make_unique<Rows>(image);
  return rows->start() ? std::move(rows) : nullptr;
}

/// One bit a pixel, the highest bit first, to bytes of 0 and 255.
inline void expandBits(const std::uint8_t* bits, int width, bool one_is_white, std::uint8_t* out) {
  for (int column = 0; column < width; ++column) {
    const bool is_one = ((bits[column / 8] >> (7 - column % 8)) & 1) != 0;
    out[column] = is_one == one_is_white ? 255 : 0;
  }
}

}  // namespace cad2slam
