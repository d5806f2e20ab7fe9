// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#include <string>

#include "cad2slam/io/image_header.h"
#include "fuzz/require.h"

using namespace cad2slam;

/// What passes is an image of a size that may be decoded.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
  const int file = ::memfd_create("image", MFD_CLOEXEC);
  fuzz::require(file >= 0 && ::write(file, bytes, count) == static_cast<ssize_t>(count), "no memory file");
  const std::string path = "/proc/self/fd/" + std::to_string(file);
  for (const ImageCheck check : {ImageCheck::kSize, ImageCheck::kWhole}) {
    const Result<ImageHeader> header = readImageHeader(path, check);
    if (header) {
      fuzz::require(header->width_px > 0 && header->height_px > 0 &&
                        header->width_px * header->height_px <= kMostPixels && header->full_brightness <= 65535,
                    "size beyond the limit");
    } else {
      fuzz::require(!header.error().message.empty() && header.error().where == path, "error without place");
    }
  }
  ::close(file);
  return 0;
}
