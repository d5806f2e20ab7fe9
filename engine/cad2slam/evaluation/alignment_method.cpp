// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/evaluation/alignment_method.h"

#include "cad2slam/evaluation/baselines.h"
#include "cad2slam/projection/make_projector.h"
#include "cad2slam/solver/global_fit.h"

#include <utility>

namespace cad2slam {
namespace {

template <class Function>
PointFunction asFunction(Function function) {
  return [function = std::move(function)](const Eigen::Vector2d& point) -> Eigen::Vector2d { return function * point; };
}

}  // namespace

std::string methodKey(AlignmentMethod method) {
  switch (method) {
    case AlignmentMethod::kSimilarity:
      return "similarity";
    case AlignmentMethod::kAffine:
      return "affine";
    case AlignmentMethod::kThinPlateSpline:
      return "thin_plate_spline";
    case AlignmentMethod::kRigid:
      return "rigid";
    case AlignmentMethod::kRigidScaled:
      return "rigid_scaled";
    case AlignmentMethod::kStretch:
      return "stretch";
  }
  return {};
}

std::string methodLabel(AlignmentMethod method) {
  switch (method) {
    case AlignmentMethod::kThinPlateSpline:
      return "thin-plate spline";
    case AlignmentMethod::kRigid:
      return "rigid, scale 1 (paper)";
    case AlignmentMethod::kRigidScaled:
      return "rigid, scale auto";
    default:
      return methodKey(method);
  }
}

MethodFitter::MethodFitter(std::shared_ptr<const Mesh> mesh, SolverSettings stretch)
    : mesh_(mesh), stretch_(std::move(stretch)), solver_(std::move(mesh)) {}

SolverSettings MethodFitter::settings(AlignmentMethod method) const {
  if (method == AlignmentMethod::kStretch) return stretch_;
  SolverSettings rigid = defaultSettings(Model::kRigid);
  rigid.scale = method == AlignmentMethod::kRigidScaled ? stretch_.scale : ScaleSettings{ScaleRule::kFixed, 1.0};
  return rigid;
}

Result<Projector> MethodFitter::fitProjector(AlignmentMethod method, const AnchorList& anchors) {
  if (method != AlignmentMethod::kStretch && method != AlignmentMethod::kRigid &&
      method != AlignmentMethod::kRigidScaled) {
    return fail(ErrorCode::kDegenerate, "The method " + methodKey(method) + " has no mesh to make a projector of");
  }
  const Result<Solution> solution = solver_.solve(anchors, settings(method));
  if (!solution) return failAs(solution);
  return makeProjector(*mesh_, *solution);
}

Result<PointFunction> MethodFitter::fit(AlignmentMethod method, const AnchorList& anchors) {
  if (method == AlignmentMethod::kAffine) {
    if (Result<Affine2> affine = fitAffine(enabledPairs(anchors))) return asFunction(*affine);
    method = AlignmentMethod::kSimilarity;
  }
  if (method == AlignmentMethod::kThinPlateSpline) {
    if (Result<ThinPlateSpline> spline = ThinPlateSpline::fit(enabledPairs(anchors))) return asFunction(*spline);
    method = AlignmentMethod::kSimilarity;
  }
  if (method == AlignmentMethod::kSimilarity) {
    const Result<Similarity2> similarity = fitSimilarity(enabledPairs(anchors), {});
    if (!similarity) return failAs(similarity);
    return asFunction(*similarity);
  }
  const Result<Projector> projector = fitProjector(method, anchors);
  if (!projector) return failAs(projector);
  return PointFunction([projector = *projector](const Eigen::Vector2d& point) -> Eigen::Vector2d {
    return projector.slamFromBlueprint({point, 0.0}, OutsidePolicy::kRigid).pose.translation;
  });
}

}  // namespace cad2slam
