// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/services/screen_pixels.h"

#include <opencv2/imgproc.hpp>

namespace cad2slam {
namespace {

cv::Mat overWhite(const cv::Mat& bgra) {
  cv::Mat out(bgra.size(), CV_8UC4);
  for (int row = 0; row < bgra.rows; ++row) {
    const auto* from = bgra.ptr<cv::Vec4b>(row);
    auto* to = out.ptr<cv::Vec4b>(row);
    for (int column = 0; column < bgra.cols; ++column) {
      const cv::Vec4b pixel = from[column];
      const int alpha = pixel[3];
      const auto mixed = [alpha](int value) {
        return static_cast<uchar>((value * alpha + 255 * (255 - alpha) + 127) / 255);
      };
      to[column] = cv::Vec4b(mixed(pixel[0]), mixed(pixel[1]), mixed(pixel[2]), 255);
    }
  }
  return out;
}

}  // namespace

cv::Mat screenPixels(const cv::Mat& rows, std::uint32_t full_brightness) {
  const bool is_wide = rows.depth() == CV_16U;
  const double white = full_brightness > 0 ? full_brightness : is_wide ? 65535.0 : 255.0;
  cv::Mat narrow = rows;
  if (is_wide || white < 255.0) rows.convertTo(narrow, CV_8U, 255.0 / white);
  if (narrow.channels() == 1) return narrow;
  if (narrow.channels() == 4) return overWhite(narrow);
  cv::Mat out;
  cv::cvtColor(narrow, out, cv::COLOR_BGR2BGRA);
  return out;
}

}  // namespace cad2slam
