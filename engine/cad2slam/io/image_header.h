// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>

#include "cad2slam/core/result.h"

namespace cad2slam {

enum class ImageFormat { kBmp, kJpeg, kPng, kPnm, kTiff };

/// What an image file says of itself before a pixel is decoded.
struct ImageHeader {
  std::uint64_t width_px = 0;
  std::uint64_t height_px = 0;
  /// Sample value of full brightness in the decoded raster where it is not the largest of its type (PGM's maxval).
  std::uint32_t full_brightness = 0;
  ImageFormat format = ImageFormat::kPnm;
  char pnm_kind = 0;            ///< of a PNM file: '1' to '6', as behind its P; else 0
  std::uint64_t pixels_at = 0;  ///< [byte] where the pixels of a binary PNM file begin
};

inline constexpr std::uint64_t kMostPixels = 30'000ULL * 30'000ULL;

/// How much of an image file is looked at.
enum class ImageCheck {
  kSize,   ///< the header alone
  kWhole,  ///< also what tells damage and a lost end, where the format allows it without decoding
};

/// Reads and checks the header of a PGM, PPM, PNG, JPG, BMP or TIFF file by its content. kMalformed for another format,
/// for a size of zero or beyond kMostPixels, and for a file that is too short for the size it claims. What passes
/// kWhole may be given to a decoder: those allocate before they read, and print or keep silent about damage.
[[nodiscard]] Result<ImageHeader> readImageHeader(const std::filesystem::path& image, ImageCheck check);

}  // namespace cad2slam
