// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>

#include <filesystem>
#include <memory>

#include "cad2slam/core/result.h"

namespace cad2slam {

/// Reads the picture of a map from the top down, so that a large one never lies in memory as a whole. PNG files are
/// decoded row by row; other formats by OpenCV in one piece. Transparent pixels are shown over white.
class StripReader {
 public:
  [[nodiscard]] static Result<std::unique_ptr<StripReader>> open(const std::filesystem::path& image);
  virtual ~StripReader() = default;

  [[nodiscard]] virtual cv::Size size() const = 0;
  /// Whether the file can have transparent pixels.
  [[nodiscard]] virtual bool hasAlpha() const = 0;
  /// The next rows, at most `rows`, as CV_8UC4 in the order of QImage::Format_RGB32, or as CV_8UC1 when the file holds
  /// no colour by its type. Empty at the end.
  [[nodiscard]] virtual Result<cv::Mat> read(int rows) = 0;
};

}  // namespace cad2slam
