// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>

#include <cstdint>

namespace cad2slam {

/// Rows of PictureRows as a screen shows them: grey as CV_8UC1, colour as CV_8UC4 in the order of
/// QImage::Format_RGB32, what is transparent over white. `full_brightness` as in PictureRows.
[[nodiscard]] cv::Mat screenPixels(const cv::Mat& rows, std::uint32_t full_brightness);

}  // namespace cad2slam
