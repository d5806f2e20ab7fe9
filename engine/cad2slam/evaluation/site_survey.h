// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cad2slam/core/result.h"
#include "cad2slam/evaluation/anchor_errors.h"
#include "cad2slam/simulation/site_generator.h"

namespace cad2slam {

struct SurveyOptions {
  int sites = 200;
  std::uint64_t first_seed = 1;
  std::optional<double> cell_size_m;  ///< empty: automatic
  std::optional<int> anchors;         ///< instead of each site's own number
};

/// Mean true errors of all methods on one random site.
struct SurveyedSite {
  std::uint64_t seed = 0;
  SiteKind kind = SiteKind::kOffice;
  AnchorLayout layout = AnchorLayout::kSpread;
  double size_m = 0.0;
  double plan_scale = 1.0;
  std::size_t anchors = 0;
  std::vector<double> mean_error_m;  ///< one for each method, in the order of the options; infinite where it failed
};

struct SiteSurvey {
  std::vector<SurveyedSite> sites;
  std::vector<AlignmentMethod> methods;

  /// Over all sites: exp(mean(log(error of the method / error of the best of `others`))). Below 1 it is better than the
  /// best of them; the best is chosen afresh at each site, which nobody can do who does not know the truth.
  [[nodiscard]] double ratioToBest(AlignmentMethod method, const std::vector<AlignmentMethod>& others) const;
  /// Geometric mean of the sites' mean errors [m].
  [[nodiscard]] double geometricMean(AlignmentMethod method) const;
  /// Part of the sites at which the method's error is at most `factor` times that of the best of `others`.
  [[nodiscard]] double shareWithin(AlignmentMethod method, const std::vector<AlignmentMethod>& others,
                                   double factor) const;
};

/// Makes random sites with known truth, seeds counting up, and measures each method all over their free space. Plans
/// more than 8 % off scale are solved as of unknown scale, as an installer would say so.
[[nodiscard]] Result<SiteSurvey> surveySites(const SurveyOptions& survey, const EvaluationOptions& options);

[[nodiscard]] std::string siteKindName(SiteKind kind);
[[nodiscard]] std::string anchorLayoutName(AnchorLayout layout);

}  // namespace cad2slam
