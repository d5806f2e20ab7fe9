// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/place_anchor_flow.h"

#include "ui/convert.h"
#include "ui/document/anchor_commands.h"
#include "ui/document/project_document.h"

namespace cad2slam {

PlaceAnchorFlow::PlaceAnchorFlow(ProjectDocument& document, QObject* parent) : QObject(parent), document_(document) {
  connect(&document_, &ProjectDocument::changed, this, [this](const ChangeEvent& event) {
    if (event.what & Change::kPending && !document_.pending()) prediction_.reset();
  });
}

std::optional<PlaceAnchorFlow::Half> PlaceAnchorFlow::half() const {
  const std::optional<PendingAnchor> pending = document_.pending();
  if (!pending) return std::nullopt;
  return Half{pending->in_blueprint ? Side::kBlueprint : Side::kSlam, {pending->x_m, pending->y_m}, snapped_};
}

void PlaceAnchorFlow::setPrediction(std::optional<QPointF> point_m) {
  prediction_ = point_m;
}

void PlaceAnchorFlow::click(Side side, const QPointF& point_m, bool snapped) {
  if (document_.isLocked() || !document_.currentMap()) return;
  const std::optional<Half> first = half();
  if (first && first->side != side) return complete(*first, point_m, snapped);
  snapped_ = snapped;
  prediction_.reset();
  document_.setPending(PendingAnchor{side == Side::kBlueprint, point_m.x(), point_m.y()});
}

bool PlaceAnchorFlow::acceptPrediction() {
  const std::optional<Half> first = half();
  if (!first || !prediction_ || document_.isLocked()) return false;
  complete(*first, *prediction_, false);
  return true;
}

bool PlaceAnchorFlow::cancel() {
  if (!half()) return false;
  document_.setPending(std::nullopt);
  return true;
}

void PlaceAnchorFlow::complete(const Half& first, const QPointF& counterpart, bool snapped) {
  const bool from_blueprint = first.side == Side::kBlueprint;
  const QPointF in_blueprint = from_blueprint ? first.point_m : counterpart;
  const QPointF in_slam = from_blueprint ? counterpart : first.point_m;
  const bool any_snapped = snapped || first.snapped;
  document_.setPending(std::nullopt);
  emit completed(edit::addAnchor(document_, toEigen(in_blueprint), toEigen(in_slam), any_snapped));
}

}  // namespace cad2slam
