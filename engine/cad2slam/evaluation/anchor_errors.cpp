// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/evaluation/anchor_errors.h"

#include "cad2slam/evaluation/parallel_for.h"
#include "cad2slam/simulation/seeded_random.h"

#include <algorithm>
#include <limits>
#include <mutex>
#include <numeric>
#include <string>

namespace cad2slam {
namespace {

/// One solve: which anchors are seen and which are tested.
struct Trial {
  AnchorList seen;
  AnchorList tested;
};

AnchorList enabledOnly(const AnchorList& anchors) {
  AnchorList enabled;
  std::copy_if(anchors.begin(), anchors.end(), std::back_inserter(enabled),
               [](const Anchor& anchor) { return anchor.enabled; });
  return enabled;
}

Result<AnchorList> usableAnchors(const AnchorList& anchors) {
  AnchorList enabled = enabledOnly(anchors);
  if (enabled.size() < 3) {
    return fail(ErrorCode::kDegenerate,
                "Testing anchors against each other needs at least 3 enabled anchors, here are " +
                    std::to_string(enabled.size()));
  }
  return enabled;
}

/// Errors of every method in every trial: [method][trial][tested anchor].
std::vector<std::vector<std::vector<double>>> runTrials(const std::shared_ptr<const Mesh>& mesh,
                                                        const std::vector<Trial>& trials,
                                                        const EvaluationOptions& options) {
  const std::size_t methods = options.methods.size();
  const std::size_t steps = trials.size() * methods;
  std::vector<std::vector<std::vector<double>>> errors(methods, std::vector<std::vector<double>>(trials.size()));
  std::vector<std::unique_ptr<MethodFitter>> fitters(workerCount(steps, options.threads));
  std::mutex progress_mutex;
  std::size_t done = 0;
  parallelFor(steps, options.threads, [&](unsigned worker, std::size_t step) {
    const std::size_t method = step % methods;
    const Trial& trial = trials[step / methods];
    if (!fitters[worker]) fitters[worker] = std::make_unique<MethodFitter>(mesh, options.stretch);
    const Result<PointFunction> function = fitters[worker]->fit(options.methods[method], trial.seen);
    for (const Anchor& anchor : trial.tested) {
      errors[method][step / methods].push_back(function ? ((*function)(anchor.in_blueprint) - anchor.in_slam).norm()
                                                        : std::numeric_limits<double>::infinity());
    }
    const std::lock_guard lock(progress_mutex);
    ++done;
    if (options.on_progress) options.on_progress(done, steps);
  });
  return errors;
}

std::vector<MethodErrors> collect(const std::vector<std::vector<std::vector<double>>>& errors,
                                  const EvaluationOptions& options, std::size_t first_trial, std::size_t trial_count) {
  std::vector<MethodErrors> collected;
  for (std::size_t method = 0; method < options.methods.size(); ++method) {
    MethodErrors result;
    result.method = options.methods[method];
    for (std::size_t trial = first_trial; trial < first_trial + trial_count; ++trial) {
      result.errors_m.insert(result.errors_m.end(), errors[method][trial].begin(), errors[method][trial].end());
    }
    result.statistics = summarise(result.errors_m);
    collected.push_back(std::move(result));
  }
  return collected;
}

}  // namespace

Result<LeaveOneOut> evaluateLeaveOneOut(const std::shared_ptr<const Mesh>& mesh, const AnchorList& anchors,
                                        const EvaluationOptions& options) {
  const Result<AnchorList> enabled = usableAnchors(anchors);
  if (!enabled) return failAs(enabled);
  LeaveOneOut result;
  std::vector<Trial> trials;
  for (std::size_t left_out = 0; left_out < enabled->size(); ++left_out) {
    Trial trial{*enabled, {(*enabled)[left_out]}};
    trial.seen.erase(trial.seen.begin() + static_cast<std::ptrdiff_t>(left_out));
    trials.push_back(std::move(trial));
    result.anchors.push_back((*enabled)[left_out].id);
  }
  result.methods = collect(runTrials(mesh, trials, options), options, 0, trials.size());
  return result;
}

Result<LearningCurve> evaluateLearningCurve(const std::shared_ptr<const Mesh>& mesh, const AnchorList& anchors,
                                            const CurveOptions& curve, const EvaluationOptions& options) {
  const Result<AnchorList> enabled = usableAnchors(anchors);
  if (!enabled) return failAs(enabled);
  if (curve.draws < 1 || std::any_of(curve.sizes.begin(), curve.sizes.end(), [](int size) { return size < 2; })) {
    return fail(ErrorCode::kOutOfDomain, "A learning curve needs sizes of at least 2 anchors and at least one draw");
  }
  LearningCurve result;
  std::vector<Trial> trials;
  for (const int size : curve.sizes) {
    if (static_cast<std::size_t>(size) >= enabled->size()) continue;
    result.points.push_back({size, {}});
    SeededRandom random(curve.seed * 1'000'003U + static_cast<std::uint64_t>(size));  // sizes do not disturb each other
    for (int draw = 0; draw < curve.draws; ++draw) {
      std::vector<std::size_t> order(enabled->size());
      std::iota(order.begin(), order.end(), std::size_t{0});
      for (std::size_t i = order.size(); i > 1; --i) {
        std::swap(order[i - 1], order[static_cast<std::size_t>(random.integer(0, static_cast<int>(i) - 1))]);
      }
      Trial trial;
      for (std::size_t i = 0; i < order.size(); ++i) {
        (i < static_cast<std::size_t>(size) ? trial.seen : trial.tested).push_back((*enabled)[order[i]]);
      }
      trials.push_back(std::move(trial));
    }
  }
  const auto errors = runTrials(mesh, trials, options);
  const auto draws = static_cast<std::size_t>(curve.draws);
  for (std::size_t i = 0; i < result.points.size(); ++i) {
    result.points[i].methods = collect(errors, options, i * draws, draws);
  }
  return result;
}

}  // namespace cad2slam
