// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/document/anchor_selection.h"
#include "ui/document/judgement.h"
#include "ui/document/project_document.h"
#include "ui/services/alignment.h"
#include "ui/services/raster_store.h"
#include "ui/tools/place_anchor_flow.h"

#include <QObject>
#include <QPointF>

#include <map>
#include <optional>

namespace cad2slam {

/// A place carried from one side to the other.
struct CarriedPoint {
  QPointF point_m;
  double turn_rad = 0.0;  ///< how much directions turn on the way
  double scale = 1.0;     ///< metres there for each metre here
  bool certain = true;    ///< false where it is extrapolated
};

/// All of the app that is not a widget: the document with everything that follows it. Windows, tools and tests stand
/// on this.
class Session : public QObject {
  Q_OBJECT

 public:
  explicit Session(QObject* parent = nullptr);

  [[nodiscard]] ProjectDocument& document() { return document_; }
  [[nodiscard]] AnchorSelection& selection() { return selection_; }
  [[nodiscard]] Alignment& alignment() { return alignment_; }
  [[nodiscard]] RasterStore& rasters() { return rasters_; }
  [[nodiscard]] PlaceAnchorFlow& flow() { return flow_; }

  /// Verdicts on the anchors of the current SLAM map by the last result.
  [[nodiscard]] const std::map<AnchorId, AnchorJudgement>& judgements() const { return judgements_; }
  [[nodiscard]] const AlignmentSummary& summary() const { return summary_; }

  /// Through the last result; empty while there is none or it has no answer there.
  [[nodiscard]] std::optional<CarriedPoint> carry(Side from, const QPointF& point_m) const;

  /// Both images are there, so that clicks make anchors.
  [[nodiscard]] bool isReady() const { return rasters_.frame(Side::kBlueprint) && rasters_.frame(Side::kSlam); }

 signals:
  void judged();

 private:
  void judge();
  void predict();

  ProjectDocument document_;
  // Before the rasters: it drops its images on a change that the rasters answer with new ones.
  Alignment alignment_;
  RasterStore rasters_;
  AnchorSelection selection_;
  PlaceAnchorFlow flow_;
  std::map<AnchorId, AnchorJudgement> judgements_;
  AlignmentSummary summary_;
};

}  // namespace cad2slam
