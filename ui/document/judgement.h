// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cad2slam/solver/solution.h"
#include "ui/document/document_state.h"

#include <map>
#include <optional>
#include <vector>

namespace cad2slam {

enum class AnchorClass {
  kPlain,  ///< no number to judge by yet
  kOk,
  kLook,      ///< worth a look
  kBad,       ///< most probably wrong
  kDisabled,  ///< not used
};

/// What the table and the views say of one anchor.
struct AnchorJudgement {
  AnchorClass judged = AnchorClass::kPlain;
  std::optional<double> residual_m;
  std::optional<double> leave_one_out_m;
  bool is_check = false;  ///< disabled: its numbers tell how well the others predict it

  friend bool operator==(const AnchorJudgement&, const AnchorJudgement&) = default;
};

/// Numbers of the footer; metres.
struct AlignmentSummary {
  std::size_t used = 0;
  std::size_t total = 0;
  std::optional<double> rms_residual_m;          ///< sqrt(mean(residual^2)) of the anchors used
  std::optional<double> max_residual_m;          ///< largest residual of the anchors used
  std::optional<double> median_leave_one_out_m;  ///< of the anchors used, from 4 of them
};

/// Anchors used from which leave-one-out says something.
inline constexpr std::size_t kLeaveOneOutFrom = 4;
/// Where the bent map is hard to guess from the neighbours all anchors are missed by much; the bad one is worse than
/// most.
inline constexpr double kAgainstMedian = 2.0;
/// Standard deviations above the mean, and how many anchors used have a meaningful one.
inline constexpr double kSpreads = 2.0;
inline constexpr std::size_t kSpreadFrom = 6;

/// Judges each anchor: by its leave-one-out error from 4 anchors on, else by its residual. "Bad" is what is above the
/// look limit and also stands out: the alignment does not reach it either (residual above the ok limit), or it is
/// missed by more than twice the median. A few good anchors on a bent map are all above the limit; when all are,
/// isUnpredicted() says so of the whole. "Bad" is also what lies more than two standard deviations above the mean of an
/// otherwise plausible set (and is not "ok" by itself). `slam_m_per_px`: of the SLAM map; anchors without a fit are
/// plain or disabled.
[[nodiscard]] std::map<AnchorId, AnchorJudgement> judgeAnchors(const AnchorList& anchors,
                                                               const std::vector<AnchorFit>& fits,
                                                               const ClassLimits& limits, double slam_m_per_px);

/// The fits may be older than the anchors: what was switched off or deleted since is not counted.
[[nodiscard]] AlignmentSummary summarize(const AnchorList& anchors, const std::vector<AnchorFit>& fits);

/// Whether the anchors do not predict each other: most would be missed by more than the look limit without themselves.
/// False below 4 anchors, which say nothing of it.
[[nodiscard]] bool isUnpredicted(const AlignmentSummary& summary, const ClassLimits& limits, double slam_m_per_px);

}  // namespace cad2slam
