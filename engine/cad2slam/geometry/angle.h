// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

namespace cad2slam {

inline constexpr double kPi = 3.14159265358979323846;

/// The same direction in [-pi, pi). Constant time; NaN for a non-finite angle.
inline double wrapAngle(double angle_rad) {
  const double wrapped = angle_rad - 2.0 * kPi * std::floor((angle_rad + kPi) / (2.0 * kPi));
  return wrapped >= kPi ? -kPi : wrapped;  // rounding can land on +pi itself
}

}  // namespace cad2slam
