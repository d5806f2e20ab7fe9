// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include <cmath>
#include <cstdint>
#include <random>

#include "cad2slam/geometry/angle.h"

namespace cad2slam {

/// Random numbers that are the same for the same seed with every standard library: the engine is standardised, the
/// distributions of <random> are not.
class SeededRandom {
 public:
  explicit SeededRandom(std::uint64_t seed) : engine_(seed) {}

  double uniform() { return static_cast<double>(engine_() >> 11) * 0x1.0p-53; }  ///< in [0, 1)
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  int integer(int low, int high) { return low + static_cast<int>(uniform() * (high - low + 1)); }  ///< both included
  bool chance(double probability) { return uniform() < probability; }
  /// Mean 0, deviation 1 (Box and Muller, one of the pair).
  double normal() { return std::sqrt(-2.0 * std::log(1.0 - uniform())) * std::cos(2.0 * kPi * uniform()); }
  Eigen::Vector2d normal2() {
    const double x = normal();
    return {x, normal()};
  }
  std::uint64_t seed() { return engine_(); }  ///< for a stream of its own

 private:
  std::mt19937_64 engine_;
};

}  // namespace cad2slam
