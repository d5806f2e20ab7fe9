// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

namespace cad2slam {

/// State of a running solve after one iteration.
struct IterationReport {
  int iteration = 0;
  double cost = 0.0;
  double relative_gradient = 1.0;  ///< |gradient| as a part of the gradient at the start
};

enum class NextStep { kContinue, kStop };

/// Called after each iteration, on the thread that solves. kStop ends the solve with ErrorCode::kCancelled.
using IterationCallback = std::function<NextStep(const IterationReport&)>;

}  // namespace cad2slam
