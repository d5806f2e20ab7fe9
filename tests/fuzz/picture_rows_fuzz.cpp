// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#include <string>

#include "cad2slam/io/image_header.h"
#include "cad2slam/io/picture_rows.h"
#include "fuzz/require.h"

using namespace cad2slam;

namespace {

constexpr std::int64_t kMostDecoded = 1 << 20;  // larger ones only take time

/// All rows of the announced size, or an error that says where.
void readAll(PictureRows& picture, const std::string& path) {
  int rows = 0;
  while (true) {
    const Result<cv::Mat> strip = picture.read(7);
    if (!strip) {
      fuzz::require(!strip.error().message.empty() && strip.error().where == path, "error without place");
      return;
    }
    if (strip->empty()) break;
    fuzz::require(strip->cols == picture.width() && strip->type() == picture.type(), "a row of another kind");
    rows += strip->rows;
  }
  fuzz::require(rows == picture.height(), "rows are missing");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
  const int file = ::memfd_create("image", MFD_CLOEXEC);
  fuzz::require(file >= 0 && ::write(file, bytes, count) == static_cast<ssize_t>(count), "no memory file");
  const std::string path = "/proc/self/fd/" + std::to_string(file);
  // What is decoded in one piece is OpenCV's, and the same code for all programs.
  const bool is_bmp = count > 1 && bytes[0] == 'B' && bytes[1] == 'M';
  const Result<ImageHeader> header = readImageHeader(path, ImageCheck::kSize);
  if (header && !is_bmp && static_cast<std::int64_t>(header->width_px * header->height_px) <= kMostDecoded) {
    const Result<std::unique_ptr<PictureRows>> picture = PictureRows::open(path);
    if (picture) {
      readAll(**picture, path);
    } else {
      fuzz::require(!picture.error().message.empty() && picture.error().where == path, "error without place");
    }
  }
  ::close(file);
  return 0;
}
