// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/io/file_descriptor.h"
#include "cad2slam/io/picture_decoders.h"

#include <cstring>

namespace cad2slam {
namespace {

/// Binary PNM: a text header, then the rows one after the other (P4 bits, P5 grey, P6 red green blue; two bytes a
/// sample, the high one first, when the largest value is beyond 255).
class PnmRows : public PictureRows {
 public:
  PnmRows(const std::filesystem::path& image, FileDescriptor file, const ImageHeader& header)
      : PictureRows(image), file_(std::move(file)), pixels_at_(header.pixels_at), kind_(header.pnm_kind) {
    is_wide_ = header.full_brightness > 255;
    describe(static_cast<int>(header.width_px), static_cast<int>(header.height_px),
             CV_MAKETYPE(is_wide_ ? CV_16U : CV_8U, kind_ == '6' ? 3 : 1));
    const auto columns = static_cast<std::size_t>(width());
    row_bytes_ = kind_ == '4' ? (columns + 7) / 8 : columns * CV_ELEM_SIZE(type());
  }

 private:
  Result<void> decode(int first, cv::Mat& rows) override {
    const std::size_t wanted = row_bytes_ * static_cast<std::size_t>(rows.rows);
    const Result<std::string> bytes = file_.readAt(pixels_at_ + row_bytes_ * static_cast<std::size_t>(first), wanted);
    if (!bytes) return failAs(bytes);
    if (bytes->size() < wanted) return fail(ErrorCode::kMalformed, "is cut off: the image is not complete", image());
    for (int row = 0; row < rows.rows; ++row) {
      decodeRow(reinterpret_cast<const std::uint8_t*>(bytes->data()) + row_bytes_ * static_cast<std::size_t>(row),
                rows.ptr(row));
    }
    return {};
  }

  void decodeRow(const std::uint8_t* from, std::uint8_t* to) const {
    if (kind_ == '4') return expandBits(from, width(), false, to);
    const int channels = CV_MAT_CN(type());
    if (channels == 1 && !is_wide_) {
      std::memcpy(to, from, row_bytes_);
      return;
    }
    for (int column = 0; column < width(); ++column) {
      for (int channel = 0; channel < channels; ++channel) {
        const int sample = column * channels + channel;
        const int target = column * channels + channels - 1 - channel;  // red first becomes blue first
        if (is_wide_) {
          reinterpret_cast<std::uint16_t*>(to)[target] =
              static_cast<std::uint16_t>(from[2 * sample] << 8 | from[2 * sample + 1]);
        } else {
          to[target] = from[sample];
        }
      }
    }
  }

  FileDescriptor file_;
  std::uint64_t pixels_at_;
  char kind_;
  bool is_wide_ = false;
  std::size_t row_bytes_ = 0;
};

}  // namespace

std::unique_ptr<PictureRows> openPnmRows(const std::filesystem::path& image, const ImageHeader& header) {
  if (header.pnm_kind < '4' || header.pnm_kind > '6') return nullptr;
  Result<FileDescriptor> file = openRegularFile(image);
  if (!file) return nullptr;
  return std::make_unique<PnmRows>(image, std::move(*file), header);
}

}  // namespace cad2slam
