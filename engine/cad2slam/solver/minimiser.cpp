// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/solver/minimiser.h"

#include <cmath>
#include <deque>
#include <utility>
#include <vector>

namespace cad2slam {
namespace {

using Eigen::VectorXd;

/// Pairs of steps and gradient changes since the last factorisation.
class LimitedMemory {
 public:
  void clear() { pairs_.clear(); }

  void add(VectorXd step, VectorXd change) {
    const double curvature = step.dot(change);
    if (!(curvature > 1e-12 * step.norm() * change.norm())) return;
    if (pairs_.size() == kPairs) pairs_.pop_front();
    pairs_.push_back({std::move(step), std::move(change), 1.0 / curvature});
  }

  /// -H gradient, with `normal` as the inverse of the initial Hessian. False when the solve failed.
  bool direction(const VectorXd& gradient, NormalMatrix& normal, VectorXd& result) const {
    VectorXd q = -gradient;
    std::vector<double> alpha(pairs_.size());
    for (std::size_t k = pairs_.size(); k-- > 0;) {
      alpha[k] = pairs_[k].inverse_curvature * pairs_[k].step.dot(q);
      q -= alpha[k] * pairs_[k].change;
    }
    if (!normal.solve(q, result)) return false;
    for (std::size_t k = 0; k < pairs_.size(); ++k) {
      const double beta = pairs_[k].inverse_curvature * pairs_[k].change.dot(result);
      result += (alpha[k] - beta) * pairs_[k].step;
    }
    return true;
  }

 private:
  struct Pair {
    VectorXd step;
    VectorXd change;
    double inverse_curvature;
  };
  static constexpr std::size_t kPairs = 12;
  std::deque<Pair> pairs_;
};

struct Point {
  VectorXd x;
  VectorXd gradient;
  double cost = 0.0;
};

double maxNorm(const VectorXd& vector) {
  return vector.size() > 0 ? vector.lpNorm<Eigen::Infinity>() : 0.0;
}

void evaluate(const Objective& objective, Point& at) {
  at.cost = gradientAt(objective, at.x.data(), at.gradient.data());
}

/// Backtracks along `direction` until the cost falls enough; near the minimum, where the fall drowns in rounding, until
/// the gradient falls. False when no step does.
bool lineSearch(const Objective& objective, const Point& from, const VectorXd& direction, Point& to) {
  const double slope = from.gradient.dot(direction);
  if (!(slope < 0.0)) return false;
  double step = 1.0;
  for (int attempt = 0; attempt < 12; ++attempt) {
    to.x = from.x + step * direction;
    evaluate(objective, to);
    const bool falls = to.cost <= from.cost + 1e-4 * step * slope;
    const bool flat = to.cost <= from.cost * (1.0 + 1e-13) && to.gradient.norm() < from.gradient.norm();
    if (std::isfinite(to.cost) && (falls || flat)) return true;
    const double curved = 2.0 * (to.cost - from.cost - step * slope);
    const double best = std::isfinite(to.cost) && curved > 0.0 ? -slope * step * step / curved : 0.0;
    step = std::min(0.5 * step, std::max(0.1 * step, best));
  }
  return false;
}

}  // namespace

MinimiserReport minimise(const Objective& objective, VectorXd& x, NormalMatrix& normal, const MinimiserOptions& options,
                         const IterationCallback& on_iteration) {
  constexpr double kLargestDamping = 1e6;
  constexpr double kGoodProgress = 0.35;  // of the gradient that may be left after a step with a used factor
  Point now{x, VectorXd(x.size()), 0.0};
  Point next{VectorXd(x.size()), VectorXd(x.size()), 0.0};
  evaluate(objective, now);

  MinimiserReport report;
  LimitedMemory memory;
  VectorXd direction;
  double damping = 0.0;
  bool factor_is_fresh = false;
  bool needs_factor = !normal.adaptFactor(objective, now.x.data());
  int slow_steps = 0;
  const auto relative = [&](const Point& at) { return maxNorm(at.gradient) / options.gradient_at_start; };

  while (true) {
    report.cost = now.cost;
    report.relative_gradient = relative(now);
    report.converged = report.relative_gradient <= options.gradient_tolerance;
    report.finite = std::isfinite(now.cost) && std::isfinite(report.relative_gradient);
    if (report.converged || !report.finite || report.iterations >= options.max_iterations) break;

    if (needs_factor) {
      memory.clear();
      while (!normal.factorise(objective, now.x.data(), damping) && damping < kLargestDamping) {
        damping = std::max(1e-8, 10.0 * damping);
      }
      if (!normal.hasFactorFor(objective)) {
        report.finite = false;
        break;
      }
      needs_factor = false;
      factor_is_fresh = true;
      slow_steps = 0;
    }
    if (!memory.direction(now.gradient, normal, direction) || !lineSearch(objective, now, direction, next)) {
      // A fresh factor without a step down: at the floor of rounding, or the model is too long: damp it.
      if (factor_is_fresh) {
        if (damping >= kLargestDamping || report.relative_gradient < 1e-8) break;
        damping = std::max(1e-4, 10.0 * damping);
      }
      needs_factor = true;
      ++report.iterations;
      continue;
    }
    memory.add(next.x - now.x, next.gradient - now.gradient);
    slow_steps = next.gradient.norm() > kGoodProgress * now.gradient.norm() ? slow_steps + 1 : 0;
    std::swap(now, next);
    ++report.iterations;
    factor_is_fresh = false;
    if (slow_steps >= 2) {
      needs_factor = true;
      damping = damping > 1e-6 ? 0.1 * damping : 0.0;
    }
    if (on_iteration && on_iteration({report.iterations, now.cost, relative(now)}) == NextStep::kStop) {
      report.cancelled = true;
      break;
    }
  }
  x = now.x;
  return report;
}

}  // namespace cad2slam
