// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/main_window/session.h"

#include "ui/convert.h"

#include <Eigen/LU>

#include <cmath>

namespace cad2slam {

Session::Session(QObject* parent)
    : QObject(parent), alignment_(document_), rasters_(document_), selection_(document_), flow_(document_) {
  connect(&rasters_, &RasterStore::changed, this,
          [this] { alignment_.setImages(rasters_.grid(Side::kBlueprint), rasters_.frame(Side::kSlam)); });
  connect(&alignment_, &Alignment::resultChanged, this, &Session::judge);
  connect(&alignment_, &Alignment::resultChanged, this, &Session::predict);
  connect(&document_, &ProjectDocument::changed, this, [this](const ChangeEvent& event) {
    if (event.what & (Change::kEverything | Change::kAnchors | Change::kPreferences | Change::kSlamMaps)) judge();
    if (event.what & Change::kPending) predict();
  });
}

void Session::judge() {
  static const std::vector<AnchorFit> kNoFits;
  const SolveResultPtr& result = alignment_.result();
  const std::optional<MapFrame>& slam = rasters_.frame(Side::kSlam);
  const std::vector<AnchorFit>& fits = result ? result->solution.anchors : kNoFits;
  judgements_ = judgeAnchors(document_.anchors(), fits, document_.state().limits, slam ? slam->resolution() : 0.0);
  summary_ = summarize(document_.anchors(), fits);
  emit judged();
}

void Session::predict() {
  const std::optional<PlaceAnchorFlow::Half> half = flow_.half();
  const SolveResultPtr& result = alignment_.result();
  std::optional<QPointF> prediction;
  // One anchor says nothing about rotation: its prediction would be a guess dressed as knowledge.
  if (half && result && result->solution.anchors_used >= 2)
    if (const std::optional<CarriedPoint> carried = carry(half->side, half->point_m)) prediction = carried->point_m;
  flow_.setPrediction(prediction);
  if (half && prediction) alignment_.requestSigma(half->side == Side::kBlueprint ? half->point_m : *prediction);
}

std::optional<CarriedPoint> Session::carry(Side from, const QPointF& point_m) const {
  const SolveResultPtr& result = alignment_.result();
  if (!result) return std::nullopt;
  const Pose2 pose{toEigen(point_m), 0.0};
  const Projection there = from == Side::kBlueprint ? result->projector.slamFromBlueprint(pose, OutsidePolicy::kRigid)
                                                    : result->projector.blueprintFromSlam(pose, OutsidePolicy::kRigid);
  if (!there.ok()) return std::nullopt;
  const Eigen::Vector2d in_blueprint = from == Side::kBlueprint ? pose.translation : there.pose.translation;
  const double area = std::abs(result->projector.jacobian(in_blueprint).determinant());
  if (!(area > 0.0)) return std::nullopt;
  const double scale = std::sqrt(area);
  return CarriedPoint{toQPointF(there.pose.translation), there.pose.heading,
                      from == Side::kBlueprint ? scale : 1.0 / scale, there.status == ProjectionStatus::kInside};
}

}  // namespace cad2slam
