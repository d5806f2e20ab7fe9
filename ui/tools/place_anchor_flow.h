// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/document/document_state.h"

#include <QObject>
#include <QPointF>

#include <optional>

namespace cad2slam {

class ProjectDocument;

/// The one way to make an anchor: a click in either view starts it, a click in the other view completes it.
///
///     idle --click A--> half in A --click A--> half in A (moved)
///                       half in A --click B--> idle, one new anchor, one undo step
///                       half in A --accept, with a predicted place--> idle, one new anchor at that place
///                       half in A --cancel--> idle, nothing happened
///
/// The half is the document's pending anchor, so that a save keeps it; undo does not know it. Knows no widgets.
class PlaceAnchorFlow : public QObject {
  Q_OBJECT

 public:
  struct Half {
    Side side = Side::kBlueprint;
    QPointF point_m;  ///< in the frame of that side
    bool snapped = false;
  };

  explicit PlaceAnchorFlow(ProjectDocument& document, QObject* parent = nullptr);

  [[nodiscard]] std::optional<Half> half() const;
  /// Where the counterpart of the half is expected; set by whoever can project.
  void setPrediction(std::optional<QPointF> point_m);
  [[nodiscard]] const std::optional<QPointF>& prediction() const { return prediction_; }

  void click(Side side, const QPointF& point_m, bool snapped);
  /// False where there was nothing to accept.
  bool acceptPrediction();
  /// False where there was nothing to cancel.
  bool cancel();

 signals:
  void completed(cad2slam::AnchorId id);

 private:
  void complete(const Half& first, const QPointF& counterpart, bool snapped);

  ProjectDocument& document_;
  std::optional<QPointF> prediction_;
  bool snapped_ = false;
};

}  // namespace cad2slam
