// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/evaluation/site_survey.h"

#include "cad2slam/evaluation/parallel_for.h"
#include "cad2slam/mesh/mesh_builder.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>

namespace cad2slam {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr double kClearlyOffScale = 0.08;
constexpr int kPlacesAlongASide = 60;

Result<SurveyedSite> surveySite(std::uint64_t seed, const SurveyOptions& survey, const EvaluationOptions& options) {
  SiteRecipe recipe = randomSiteRecipe(seed);
  if (survey.anchors) recipe.anchors.count = *survey.anchors;
  const Result<GeneratedSite> site = generateSite(recipe);
  if (!site) return failAs(site);
  Result<Mesh> mesh = buildMesh(site->building.blueprint, survey.cell_size_m);
  if (!mesh) return failAs(mesh);

  SurveyedSite row;
  row.seed = seed;
  row.kind = recipe.building.plan.kind;
  row.layout = recipe.anchors.layout;
  row.size_m = recipe.building.plan.size_m.maxCoeff();
  row.plan_scale = recipe.building.plan_scale;
  row.anchors = site->anchors.size();
  SolverSettings stretch = options.stretch;
  if (std::abs(std::log(row.plan_scale)) > kClearlyOffScale) stretch.scale.rule = ScaleRule::kLeastSquares;
  MethodFitter fitter(std::make_shared<const Mesh>(std::move(*mesh)), stretch);
  const std::vector<Eigen::Vector2d> places = freePlaces(site->building.plan, row.size_m / kPlacesAlongASide);
  for (const AlignmentMethod method : options.methods) {
    const Result<PointFunction> function = fitter.fit(method, site->anchors);
    double sum = function ? 0.0 : kNever;
    for (const Eigen::Vector2d& place : places) {
      if (!function) break;
      const Eigen::Vector2d in_blueprint = site->building.blueprint_from_plan * place;
      sum += ((*function)(in_blueprint)-site->warp.slamFromPlan(place)).norm();
    }
    row.mean_error_m.push_back(std::isfinite(sum) ? sum / static_cast<double>(places.size()) : kNever);
  }
  return row;
}

/// Errors of one method and of the best of others, at each site.
std::vector<double> logRatios(const SiteSurvey& survey, AlignmentMethod method,
                              const std::vector<AlignmentMethod>& others) {
  std::vector<double> ratios;
  for (const SurveyedSite& site : survey.sites) {
    double own = kNever;
    double best = kNever;
    for (std::size_t i = 0; i < survey.methods.size(); ++i) {
      if (survey.methods[i] == method) own = site.mean_error_m[i];
      if (std::find(others.begin(), others.end(), survey.methods[i]) != others.end()) {
        best = std::min(best, site.mean_error_m[i]);
      }
    }
    ratios.push_back(std::log(own / best));
  }
  return ratios;
}

}  // namespace

double SiteSurvey::ratioToBest(AlignmentMethod method, const std::vector<AlignmentMethod>& others) const {
  return std::exp(summarise(logRatios(*this, method, others)).mean);
}

double SiteSurvey::shareWithin(AlignmentMethod method, const std::vector<AlignmentMethod>& others,
                               double factor) const {
  const std::vector<double> ratios = logRatios(*this, method, others);
  const auto within =
      std::count_if(ratios.begin(), ratios.end(), [&](double ratio) { return ratio <= std::log(factor); });
  return ratios.empty() ? 0.0 : static_cast<double>(within) / static_cast<double>(ratios.size());
}

double SiteSurvey::geometricMean(AlignmentMethod method) const {
  double sum = 0.0;
  for (const SurveyedSite& site : sites) {
    for (std::size_t i = 0; i < methods.size(); ++i) {
      if (methods[i] == method) sum += std::log(site.mean_error_m[i]);
    }
  }
  return std::exp(sum / static_cast<double>(sites.size()));
}

Result<SiteSurvey> surveySites(const SurveyOptions& survey, const EvaluationOptions& options) {
  if (survey.sites < 1) return fail(ErrorCode::kOutOfDomain, "A survey needs at least one site");
  const auto count = static_cast<std::size_t>(survey.sites);
  SiteSurvey result;
  result.methods = options.methods;
  result.sites.resize(count);
  std::optional<Error> first_error;
  std::mutex mutex;
  std::size_t done = 0;
  parallelFor(count, options.threads, [&](unsigned, std::size_t index) {
    Result<SurveyedSite> site = surveySite(survey.first_seed + index, survey, options);
    const std::lock_guard lock(mutex);
    if (site) {
      result.sites[index] = std::move(*site);
    } else if (!first_error) {
      first_error = site.error();
    }
    ++done;
    if (options.on_progress) options.on_progress(done, count);
  });
  if (first_error) return tl::unexpected<Error>(*first_error);
  return result;
}

std::string siteKindName(SiteKind kind) {
  switch (kind) {
    case SiteKind::kFlat:
      return "flat";
    case SiteKind::kOffice:
      return "office";
    case SiteKind::kCorridor:
      return "corridor";
    case SiteKind::kHall:
      return "hall";
  }
  return {};
}

std::string anchorLayoutName(AnchorLayout layout) {
  switch (layout) {
    case AnchorLayout::kSpread:
      return "spread";
    case AnchorLayout::kRandom:
      return "random";
    case AnchorLayout::kClustered:
      return "clustered";
    case AnchorLayout::kAlongRoute:
      return "along route";
  }
  return {};
}

}  // namespace cad2slam
