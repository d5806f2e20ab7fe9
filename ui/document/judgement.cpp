// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/document/judgement.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace cad2slam {
namespace {

double lookLimit(const ClassLimits& limits, double slam_m_per_px) {
  return std::max(limits.look_cells * slam_m_per_px, limits.look_m);
}

std::optional<double> finiteOrNothing(double value) {
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

}  // namespace

std::map<AnchorId, AnchorJudgement> judgeAnchors(const AnchorList& anchors, const std::vector<AnchorFit>& fits,
                                                 const ClassLimits& limits, double slam_m_per_px) {
  std::map<AnchorId, const AnchorFit*> fit_of;
  std::size_t used = 0;
  for (const AnchorFit& fit : fits) {
    fit_of[fit.id] = &fit;
    used += fit.used;
  }
  const bool by_leave_one_out = used >= kLeaveOneOutFrom;
  const auto error = [&](const AnchorFit& fit) {
    return fit.used && by_leave_one_out && std::isfinite(fit.leave_one_out_m) ? fit.leave_one_out_m : fit.residual_m;
  };
  double sum = 0.0;
  double squares = 0.0;
  for (const AnchorFit& fit : fits) {
    if (!fit.used) continue;
    sum += error(fit);
    squares += error(fit) * error(fit);
  }
  const double count = static_cast<double>(std::max<std::size_t>(used, 1));
  const double mean = sum / count;
  const double spread = std::sqrt(std::max(0.0, squares / count - mean * mean));
  const double median = summarize(anchors, fits).median_leave_one_out_m.value_or(0.0);
  const double ok = std::max(limits.ok_cells * slam_m_per_px, limits.ok_m);
  const double look = lookLimit(limits, slam_m_per_px);

  std::map<AnchorId, AnchorJudgement> judgements;
  for (const Anchor& anchor : anchors) {
    AnchorJudgement& judgement = judgements[anchor.id];
    judgement.is_check = !anchor.enabled;
    judgement.judged = anchor.enabled ? AnchorClass::kPlain : AnchorClass::kDisabled;
    const auto found = fit_of.find(anchor.id);
    if (found == fit_of.end()) continue;
    const AnchorFit& fit = *found->second;
    judgement.residual_m = finiteOrNothing(fit.residual_m);
    if (fit.used && used >= kLeaveOneOutFrom) judgement.leave_one_out_m = finiteOrNothing(fit.leave_one_out_m);
    // With one anchor everything fits, with two nearly everything: no verdict.
    if (!anchor.enabled || used < 3 || !judgement.residual_m) continue;
    const double value = error(fit);
    const bool stands_out = used >= kSpreadFrom && value > mean + kSpreads * spread;
    if (value <= ok) {
      judgement.judged = AnchorClass::kOk;
    } else if (stands_out || (value > look && (*judgement.residual_m > ok || value > kAgainstMedian * median))) {
      judgement.judged = AnchorClass::kBad;
    } else {
      judgement.judged = AnchorClass::kLook;
    }
  }
  return judgements;
}

AlignmentSummary summarize(const AnchorList& anchors, const std::vector<AnchorFit>& fits) {
  AlignmentSummary summary;
  summary.total = anchors.size();
  std::set<AnchorId> enabled;
  for (const Anchor& anchor : anchors)
    if (anchor.enabled) enabled.insert(anchor.id);
  double squares = 0.0;
  std::vector<double> leave_one_out;
  for (const AnchorFit& fit : fits) {
    if (!fit.used || !std::isfinite(fit.residual_m) || !enabled.contains(fit.id)) continue;
    ++summary.used;
    squares += fit.residual_m * fit.residual_m;
    summary.max_residual_m = std::max(summary.max_residual_m.value_or(0.0), fit.residual_m);
    if (std::isfinite(fit.leave_one_out_m)) leave_one_out.push_back(fit.leave_one_out_m);
  }
  if (summary.used > 0) summary.rms_residual_m = std::sqrt(squares / static_cast<double>(summary.used));
  if (summary.used >= kLeaveOneOutFrom && !leave_one_out.empty()) {
    const std::size_t half = leave_one_out.size() / 2;
    std::nth_element(leave_one_out.begin(), leave_one_out.begin() + static_cast<std::ptrdiff_t>(half),
                     leave_one_out.end());
    double median = leave_one_out[half];
    if (leave_one_out.size() % 2 == 0) {
      median = (median +
                *std::max_element(leave_one_out.begin(), leave_one_out.begin() + static_cast<std::ptrdiff_t>(half))) /
               2.0;
    }
    summary.median_leave_one_out_m = median;
  }
  return summary;
}

bool isUnpredicted(const AlignmentSummary& summary, const ClassLimits& limits, double slam_m_per_px) {
  return summary.median_leave_one_out_m.value_or(0.0) > lookLimit(limits, slam_m_per_px);
}

}  // namespace cad2slam
