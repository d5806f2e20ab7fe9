// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <vector>

#include "cad2slam/anchors/anchor.h"
#include "cad2slam/core/result.h"
#include "cad2slam/evaluation/alignment_method.h"
#include "cad2slam/evaluation/error_statistics.h"
#include "cad2slam/mesh/mesh.h"

namespace cad2slam {

/// Called after each finished step, from any of the working threads but never from two at once.
using ProgressCallback = std::function<void(std::size_t done, std::size_t total)>;

struct EvaluationOptions {
  std::vector<AlignmentMethod> methods{kAllMethods.begin(), kAllMethods.end()};
  SolverSettings stretch = defaultSettings(Model::kStretch);
  unsigned threads = 0;  ///< 0: one for each core
  ProgressCallback on_progress;
};

/// Errors of one method at anchors it has not seen.
struct MethodErrors {
  AlignmentMethod method = AlignmentMethod::kStretch;
  std::vector<double> errors_m;  ///< infinite where the method failed
  ErrorStatistics statistics{};
};

struct LeaveOneOut {
  std::vector<AnchorId> anchors;      ///< those enabled, in the given order
  std::vector<MethodErrors> methods;  ///< errors in the order of `anchors`
};

/// Solves again without each enabled anchor in turn and measures how far its point in the SLAM map is missed.
/// kDegenerate: fewer than three enabled anchors.
[[nodiscard]] Result<LeaveOneOut> evaluateLeaveOneOut(const std::shared_ptr<const Mesh>& mesh,
                                                      const AnchorList& anchors, const EvaluationOptions& options);

struct CurveOptions {
  std::vector<int> sizes = {4, 8, 16, 30};
  int draws = 20;
  std::uint64_t seed = 1;
};

struct LearningCurve {
  struct Point {
    int size = 0;
    std::vector<MethodErrors> methods;  ///< at all anchors that were not drawn, of all draws
  };
  std::vector<Point> points;  ///< sizes with at least one anchor left to test
};

/// For each size: draws that many of the enabled anchors, solves, and measures at the others. All methods see the same
/// draws. kDegenerate: fewer than three enabled anchors; kOutOfDomain: a size below 2 or no draw.
[[nodiscard]] Result<LearningCurve> evaluateLearningCurve(const std::shared_ptr<const Mesh>& mesh,
                                                          const AnchorList& anchors, const CurveOptions& curve,
                                                          const EvaluationOptions& options);

}  // namespace cad2slam
