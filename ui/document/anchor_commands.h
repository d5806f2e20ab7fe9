// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/document/project_document.h"

#include <QUndoCommand>

#include <functional>
#include <string>
#include <vector>

namespace cad2slam {

/// Any change of anchors of one SLAM map, as values: what they were and what they become. Steps of one gesture merge;
/// a gesture that ends where it began leaves no step.
class EditAnchorsCommand : public QUndoCommand {
 public:
  static constexpr int kNoGesture = 0;

  /// `changes`: ascending by index. `next_id`: of the document afterwards.
  EditAnchorsCommand(ProjectDocument& document, std::vector<AnchorChange> changes, AnchorId next_id,
                     const QString& text, int gesture = kNoGesture, bool interim = false);

  void redo() override;
  void undo() override;
  [[nodiscard]] int id() const override;
  bool mergeWith(const QUndoCommand* next) override;

 private:
  ProjectDocument& document_;
  std::string map_;
  std::vector<AnchorChange> changes_;
  AnchorId next_id_before_;
  AnchorId next_id_after_;
  int gesture_;
  bool interim_;
  bool first_time_ = true;
};

/// What the installer can do to anchors of the current SLAM map. Each call is one step of the undo stack, except where
/// it says otherwise. Ids that do not exist are ignored; nothing happens where nothing would change.
namespace edit {

/// A new anchor with the next free number.
AnchorId addAnchor(ProjectDocument& document, const Eigen::Vector2d& in_blueprint, const Eigen::Vector2d& in_slam,
                   bool snapped = false);
/// Moves one half. Calls with the same gesture merge to one step; `interim` while the gesture goes on.
void moveAnchor(ProjectDocument& document, AnchorId id, Side side, const Eigen::Vector2d& to, int gesture,
                bool interim = false, bool snapped = false);
/// Replaces both points, as typed into the table.
void setCoordinates(ProjectDocument& document, AnchorId id, const Eigen::Vector2d& in_blueprint,
                    const Eigen::Vector2d& in_slam);
void deleteAnchors(ProjectDocument& document, const std::vector<AnchorId>& ids);
void setEnabled(ProjectDocument& document, const std::vector<AnchorId>& ids, bool enabled);
void rename(ProjectDocument& document, AnchorId id, const std::string& name);
void setNote(ProjectDocument& document, AnchorId id, const std::string& note);
/// Exchanges the SLAM points of two anchors.
void swapCounterparts(ProjectDocument& document, AnchorId first, AnchorId second);
/// Adds anchors that came from elsewhere; a number that is taken is replaced by the next free one. `text` names the
/// step. Returns the numbers they got.
std::vector<AnchorId> addAnchors(ProjectDocument& document, AnchorList anchors, const QString& text);

}  // namespace edit
}  // namespace cad2slam
