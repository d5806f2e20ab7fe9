// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/services/strip_reader.h"

#include <algorithm>
#include <csetjmp>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

#include <png.h>
#include <opencv2/imgproc.hpp>

#include "cad2slam/io/map_file.h"

namespace cad2slam {
namespace {

constexpr png_uint_32 kLargestSide = 65'535;
constexpr std::int64_t kMostPixels = std::int64_t{1} << 30;

/// libpng reports errors by longjmp, so every call into it sits in a member that holds no object to destroy.
class PngReader : public StripReader {
 public:
  PngReader() = default;
  ~PngReader() override {
    if (png_ != nullptr) png_destroy_read_struct(&png_, &info_, nullptr);
    if (file_ != nullptr) std::fclose(file_);
  }
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;

  /// False when the file is not a PNG that can be read row by row.
  bool start(const std::filesystem::path& path) {
    file_ = std::fopen(path.c_str(), "rb");
    if (file_ == nullptr) return false;
    png_byte signature[8] = {};
    if (std::fread(signature, 1, sizeof signature, file_) != sizeof signature) return false;
    if (png_sig_cmp(signature, 0, sizeof signature) != 0) return false;
    path_ = path.string();
    png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, this, &PngReader::onError, &PngReader::onWarning);
    info_ = png_ == nullptr ? nullptr : png_create_info_struct(png_);
    return info_ != nullptr && readHeader();
  }

  [[nodiscard]] cv::Size size() const override { return size_; }
  [[nodiscard]] bool hasAlpha() const override { return has_alpha_; }

  [[nodiscard]] Result<cv::Mat> read(int rows) override {
    const int count = std::min(rows, size_.height - next_row_);
    if (count <= 0) return cv::Mat();
    cv::Mat strip(count, size_.width, grey_ ? CV_8UC1 : CV_8UC4);
    row_pointers_.resize(static_cast<std::size_t>(count));
    for (int row = 0; row < count; ++row) row_pointers_[static_cast<std::size_t>(row)] = strip.ptr(row);
    if (!readRows(static_cast<png_uint_32>(count))) {
      return fail(ErrorCode::kMalformed, "the PNG image is damaged: " + message_, path_);
    }
    next_row_ += count;
    return strip;
  }

 private:
  bool readHeader() {
    if (setjmp(png_jmpbuf(png_)) != 0) return false;
    png_init_io(png_, file_);
    png_set_sig_bytes(png_, 8);
    png_set_user_limits(png_, kLargestSide, kLargestSide);
    png_read_info(png_, info_);
    if (png_get_interlace_type(png_, info_) != PNG_INTERLACE_NONE) return false;
    const png_byte type = png_get_color_type(png_, info_);
    has_alpha_ = (type & PNG_COLOR_MASK_ALPHA) != 0 || png_get_valid(png_, info_, PNG_INFO_tRNS) != 0;
    grey_ = (type & PNG_COLOR_MASK_COLOR) == 0;
    png_set_expand(png_);
    png_set_scale_16(png_);
    if (has_alpha_) {
      png_color_16 white = {};
      white.red = white.green = white.blue = white.gray = 255;
      png_set_background(png_, &white, PNG_BACKGROUND_GAMMA_SCREEN, 0, 1.0);
    }
    if (!grey_) {
      png_set_bgr(png_);
      png_set_filler(png_, 0xff, PNG_FILLER_AFTER);
    }
    png_read_update_info(png_, info_);
    size_ = cv::Size(static_cast<int>(png_get_image_width(png_, info_)),
                     static_cast<int>(png_get_image_height(png_, info_)));
    const auto pixel_bytes = static_cast<std::size_t>(grey_ ? 1 : 4);
    if (std::int64_t{size_.width} * size_.height > kMostPixels) return false;
    return png_get_rowbytes(png_, info_) == pixel_bytes * static_cast<std::size_t>(size_.width);
  }

  bool readRows(png_uint_32 count) {
    if (setjmp(png_jmpbuf(png_)) != 0) return false;
    png_read_rows(png_, row_pointers_.data(), nullptr, count);
    return true;
  }

  static void onError(png_structp png, png_const_charp message) {
    static_cast<PngReader*>(png_get_error_ptr(png))->message_ = message;
    png_longjmp(png, 1);
  }
  static void onWarning(png_structp, png_const_charp) {}

  std::FILE* file_ = nullptr;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
  std::string path_;
  std::string message_;
  cv::Size size_;
  bool grey_ = false;
  bool has_alpha_ = false;
  int next_row_ = 0;
  std::vector<png_bytep> row_pointers_;
};

/// A picture that was decoded in one piece, handed out in strips.
class WholePicture : public StripReader {
 public:
  explicit WholePicture(cv::Mat picture) : picture_(std::move(picture)) {}

  [[nodiscard]] cv::Size size() const override { return picture_.size(); }
  [[nodiscard]] bool hasAlpha() const override { return picture_.channels() == 4; }

  [[nodiscard]] Result<cv::Mat> read(int rows) override {
    const int count = std::min(rows, picture_.rows - next_row_);
    if (count <= 0) return cv::Mat();
    cv::Mat strip = picture_.rowRange(next_row_, next_row_ + count);
    next_row_ += count;
    if (strip.depth() == CV_16U) {
      cv::Mat narrow;
      strip.convertTo(narrow, CV_8U, 1.0 / 257.0);
      strip = narrow;
    }
    cv::Mat out;
    if (strip.channels() == 1) {
      out = strip.clone();
    } else if (strip.channels() == 3) {
      cv::cvtColor(strip, out, cv::COLOR_BGR2BGRA);
    } else {
      out.create(strip.size(), CV_8UC4);
      for (int row = 0; row < strip.rows; ++row) {
        const auto* source = strip.ptr<cv::Vec4b>(row);
        auto* target = out.ptr<cv::Vec4b>(row);
        for (int column = 0; column < strip.cols; ++column) {
          const cv::Vec4b pixel = source[column];
          const int alpha = pixel[3];
          const auto overWhite = [alpha](int value) {
            return static_cast<uchar>((value * alpha + 255 * (255 - alpha) + 127) / 255);
          };
          target[column] = cv::Vec4b(overWhite(pixel[0]), overWhite(pixel[1]), overWhite(pixel[2]), 255);
        }
      }
    }
    return out;
  }

 private:
  cv::Mat picture_;
  int next_row_ = 0;
};

}  // namespace

Result<std::unique_ptr<StripReader>> StripReader::open(const std::filesystem::path& image) {
  auto png = std::make_unique<PngReader>();
  if (png->start(image)) return png;
  png.reset();
  Result<cv::Mat> picture = loadPicture(image);
  if (!picture) return failAs(picture);
  return std::make_unique<WholePicture>(std::move(*picture));
}

}  // namespace cad2slam
