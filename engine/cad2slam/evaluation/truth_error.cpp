// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/evaluation/truth_error.h"

#include <algorithm>
#include <cmath>

namespace cad2slam {

std::vector<TruePlace> truePlaces(const OccupancyGrid& blueprint, const TrueWarp& truth, double spacing_m) {
  const MapFrame& frame = blueprint.frame();
  const int step = std::max(1, static_cast<int>(std::lround(spacing_m / frame.resolution())));
  std::vector<TruePlace> places;
  for (int row = step / 2; row < frame.height(); row += step) {
    for (int column = step / 2; column < frame.width(); column += step) {
      if (blueprint.at(column, row) != CellState::kFree) continue;
      const Eigen::Vector2d place = frame.metricFromPixel({column + 0.5, row + 0.5});
      if (const std::optional<Pose2> in_slam = truth.slamFromBlueprint({place, 0.0})) {
        places.push_back({place, *in_slam});
      }
    }
  }
  return places;
}

Result<TruthErrors> evaluateTruth(const std::shared_ptr<const Mesh>& mesh, const AnchorList& anchors,
                                  const OccupancyGrid& blueprint, const TrueWarp& truth,
                                  const EvaluationOptions& options, double spacing_m) {
  TruthErrors result;
  result.places = truePlaces(blueprint, truth, spacing_m);
  if (result.places.empty()) {
    return fail(ErrorCode::kDegenerate, "The true warp covers no free place of this blueprint");
  }
  MethodFitter fitter(mesh, options.stretch);
  result.heading_rad = summarise({});
  for (std::size_t i = 0; i < options.methods.size(); ++i) {
    const Result<PointFunction> function = fitter.fit(options.methods[i], anchors);
    if (!function) return failAs(function);
    MethodErrors errors;
    errors.method = options.methods[i];
    for (const TruePlace& place : result.places) {
      errors.errors_m.push_back(((*function)(place.in_blueprint) - place.in_slam.translation).norm());
    }
    errors.statistics = summarise(errors.errors_m);
    result.methods.push_back(std::move(errors));
    if (options.methods[i] == AlignmentMethod::kStretch) {
      const Result<Projector> projector = fitter.fitProjector(AlignmentMethod::kStretch, anchors);
      if (!projector) return failAs(projector);
      std::vector<double> headings;
      for (const TruePlace& place : result.places) {
        const Projection pose = projector->slamFromBlueprint({place.in_blueprint, 0.0}, OutsidePolicy::kRigid);
        result.outside += pose.status == ProjectionStatus::kInside ? 0 : 1;
        if (pose.ok()) headings.push_back(std::abs(wrapAngle(pose.pose.heading - place.in_slam.heading)));
      }
      result.heading_rad = summarise(std::move(headings));
    }
    if (options.on_progress) options.on_progress(i + 1, options.methods.size());
  }
  return result;
}

}  // namespace cad2slam
