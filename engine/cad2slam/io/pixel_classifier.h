// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

#include <opencv2/core/mat.hpp>

#include "cad2slam/core/result.h"
#include "cad2slam/io/map_file.h"

namespace cad2slam {

/// How a map_server reads the pixels of one image.
struct PixelRules {
  MapSemantics semantics = MapSemantics::kJazzy;
  MapMode mode = MapMode::kTrinary;
  double occupied_threshold = 0.65;
  double free_threshold = 0.196;
  bool negate = false;
  std::uint32_t full_brightness = 0;  ///< sample value of white; 0: the largest of the type
};

/// What was noticed while pixels were classified.
struct PixelNotes {
  std::size_t read_differently = 0;  ///< pixels that the other MapSemantics puts into another state
  bool grey_205_is_free = false;     ///< map_saver's value of unknown is there, and counts as free
};

/// Classifies the pixels of one picture, which may come piece by piece. A value between the thresholds is unknown in
/// every mode: scale and raw maps grade how occupied a pixel is, and a graded pixel is neither free nor occupied.
class PixelClassifier {
 public:
  /// `type`: of the picture, CV_8U or CV_16U with 1, 3 or 4 channels in OpenCV's order; another one is kMalformed.
  [[nodiscard]] static Result<std::unique_ptr<PixelClassifier>> create(int type, const PixelRules& rules);
  virtual ~PixelClassifier() = default;
  PixelClassifier(const PixelClassifier&) = delete;
  PixelClassifier& operator=(const PixelClassifier&) = delete;

  /// The CellState of each pixel, CV_8UC1. `piece` is of the type this was created for.
  [[nodiscard]] virtual cv::Mat classify(const cv::Mat& piece) = 0;
  /// Of all pieces so far.
  [[nodiscard]] virtual PixelNotes notes() const = 0;

 protected:
  PixelClassifier() = default;
};

}  // namespace cad2slam
