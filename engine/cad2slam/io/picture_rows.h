// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

#include <opencv2/core/mat.hpp>

#include "cad2slam/core/result.h"

namespace cad2slam {

/// A picture that is read from the top down, so that a large one never lies in memory as a whole. PNG, JPEG, TIFF and
/// binary PNM are decoded row by row; what those readers leave out (BMP, text PNM, interlaced PNG, TIFF with a palette
/// or of separate planes) is decoded by OpenCV in one piece.
class PictureRows {
 public:
  /// Checks the whole file first (see readImageHeader). kMalformed: damaged, or neither grey nor colour of 8 or 16
  /// bits.
  [[nodiscard]] static Result<std::unique_ptr<PictureRows>> open(const std::filesystem::path& image);
  virtual ~PictureRows() = default;
  PictureRows(const PictureRows&) = delete;
  PictureRows& operator=(const PictureRows&) = delete;

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  /// CV_8UC1, CV_8UC3 (BGR), CV_8UC4 (BGRA, alpha not multiplied into the colours) or the same of 16 bits.
  [[nodiscard]] int type() const { return type_; }
  [[nodiscard]] bool hasAlpha() const { return CV_MAT_CN(type_) == 4; }
  /// Sample value of white where that is not the largest of the type; else 0.
  [[nodiscard]] std::uint32_t fullBrightness() const { return full_brightness_; }

  /// The next rows, at most `count` of them; empty at the end. kMalformed: the file is damaged here.
  [[nodiscard]] Result<cv::Mat> read(int count);

 protected:
  explicit PictureRows(const std::filesystem::path& image) : image_(image.string()) {}
  void describe(int width, int height, int type) {
    width_ = width;
    height_ = height;
    type_ = type;
  }
  [[nodiscard]] const std::string& image() const { return image_; }
  /// Where the decoder cannot go on; `reason` in its own words, empty when it has none.
  [[nodiscard]] tl::unexpected<Error> damaged(const std::string& reason) const;

  /// Fills `rows`, the first of which is `first` of the picture. They are asked for in order, each once.
  [[nodiscard]] virtual Result<void> decode(int first, cv::Mat& rows) = 0;

 private:
  std::string image_;
  int width_ = 0;
  int height_ = 0;
  int type_ = 0;
  std::uint32_t full_brightness_ = 0;
  int next_row_ = 0;
};

}  // namespace cad2slam
