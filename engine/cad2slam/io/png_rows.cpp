// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/io/picture_decoders.h"

#include <bit>
#include <csetjmp>
#include <cstdio>
#include <vector>

#include <png.h>

namespace cad2slam {
namespace {

constexpr png_uint_32 kLongestSide = png_uint_32{1} << 20;

/// libpng reports errors by longjmp, so every call into it sits in a member that holds no object to destroy.
class PngRows : public PictureRows {
 public:
  explicit PngRows(const std::filesystem::path& image) : PictureRows(image) {}
  ~PngRows() override {
    if (png_ != nullptr) png_destroy_read_struct(&png_, &info_, nullptr);
    if (file_ != nullptr) std::fclose(file_);
  }

  /// False when the file cannot be read row by row.
  bool start() {
    file_ = std::fopen(image().c_str(), "rb");
    if (file_ == nullptr) return false;
    png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, this, &PngRows::onError, &PngRows::onWarning);
    info_ = png_ == nullptr ? nullptr : png_create_info_struct(png_);
    return info_ != nullptr && readHeader();
  }

 private:
  bool readHeader() {
    if (setjmp(png_jmpbuf(png_)) != 0) return false;
    png_init_io(png_, file_);
    png_set_user_limits(png_, kLongestSide, kLongestSide);
    png_read_info(png_, info_);
    if (png_get_interlace_type(png_, info_) != PNG_INTERLACE_NONE) return false;
    const png_byte kind = png_get_color_type(png_, info_);
    const bool has_alpha = (kind & PNG_COLOR_MASK_ALPHA) != 0 || png_get_valid(png_, info_, PNG_INFO_tRNS) != 0;
    const int channels = has_alpha ? 4 : (kind & PNG_COLOR_MASK_COLOR) != 0 ? 3 : 1;
    const bool is_wide = png_get_bit_depth(png_, info_) == 16;
    png_set_expand(png_);
    if (channels == 4) png_set_gray_to_rgb(png_);
    if (channels > 1) png_set_bgr(png_);
    if (is_wide && std::endian::native == std::endian::little) png_set_swap(png_);
    png_read_update_info(png_, info_);
    describe(static_cast<int>(png_get_image_width(png_, info_)), static_cast<int>(png_get_image_height(png_, info_)),
             CV_MAKETYPE(is_wide ? CV_16U : CV_8U, channels));
    return png_get_rowbytes(png_, info_) == static_cast<std::size_t>(width()) * CV_ELEM_SIZE(type());
  }

  Result<void> decode(int /*first*/, cv::Mat& rows) override {
    row_pointers_.resize(static_cast<std::size_t>(rows.rows));
    for (int row = 0; row < rows.rows; ++row) row_pointers_[static_cast<std::size_t>(row)] = rows.ptr(row);
    if (readRows(static_cast<png_uint_32>(rows.rows))) return {};
    return damaged(message_);
  }

  bool readRows(png_uint_32 count) {
    if (setjmp(png_jmpbuf(png_)) != 0) return false;
    png_read_rows(png_, row_pointers_.data(), nullptr, count);
    return true;
  }

  static void onError(png_structp png, png_const_charp message) {
    static_cast<PngRows*>(png_get_error_ptr(png))->message_ = message;
    png_longjmp(png, 1);
  }
  static void onWarning(png_structp, png_const_charp) {}

  std::FILE* file_ = nullptr;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
  std::string message_;
  std::vector<png_bytep> row_pointers_;
};

}  // namespace

std::unique_ptr<PictureRows> openPngRows(const std::filesystem::path& image) {
  return startedRows<PngRows>(image);
}

}  // namespace cad2slam
