// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include <optional>
#include <vector>

#include "cad2slam/core/result.h"
#include "cad2slam/geometry/pose2.h"

namespace cad2slam {

/// The true function from a blueprint to a SLAM map, known because both were made by us: SLAM poses on a regular grid
/// of blueprint places, read bilinearly. NaN where there is no building.
class TrueWarp {
 public:
  /// Grid of the samples. Sample (column, row) lies at `first` + step * (column, row), so rows grow with y.
  struct Layout {
    Eigen::Vector2d first = Eigen::Vector2d::Zero();  ///< [m] in the blueprint frame
    double step_m = 0.5;
    int columns = 0;
    int rows = 0;
  };
  /// What is stored of one place: x, y [m] and heading [rad] in the SLAM frame of the blueprint pose with heading 0.
  struct Sample {
    float x;
    float y;
    float heading;
  };
  static constexpr int kMaxSamplesPerSide = 20'000;

  /// `samples` row by row. kMalformed: sizes do not fit, no positive step, an infinite number.
  [[nodiscard]] static Result<TrueWarp> create(const Layout& layout, std::vector<Sample> samples);

  [[nodiscard]] const Layout& layout() const { return layout_; }
  [[nodiscard]] const std::vector<Sample>& samples() const { return samples_; }

  /// nullopt outside of the building.
  [[nodiscard]] std::optional<Pose2> slamFromBlueprint(const Pose2& pose_in_blueprint) const;

 private:
  TrueWarp(const Layout& layout, std::vector<Sample> samples) : layout_(layout), samples_(std::move(samples)) {}

  Layout layout_;
  std::vector<Sample> samples_;
};

}  // namespace cad2slam
