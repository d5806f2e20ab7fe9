// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/document/anchor_commands.h"

#include "ui/convert.h"
#include "ui/document/command_ids.h"

#include <QCoreApplication>

#include <algorithm>
#include <utility>

namespace cad2slam {

EditAnchorsCommand::EditAnchorsCommand(ProjectDocument& document, std::vector<AnchorChange> changes, AnchorId next_id,
                                       const QString& text, int gesture, bool interim)
    : QUndoCommand(text),
      document_(document),
      map_(document.currentMapName()),
      changes_(std::move(changes)),
      next_id_before_(document.state().next_id),
      next_id_after_(next_id),
      gesture_(gesture),
      interim_(interim) {}

void EditAnchorsCommand::redo() {
  ChangeEvent event;
  // The end of a gesture wants the full answer even where the last step moved nothing.
  if (gesture_ != kNoGesture && !interim_) event.what |= Change::kAnchors;
  event.interim = interim_ && first_time_;
  event.by_history = !first_time_;
  document_.applyAnchorChanges(map_, changes_, next_id_after_, ProjectDocument::Direction::kRedo, event);
  // A gesture may end without having moved anything: it had to be announced, but leaves no step of its own.
  if (std::exchange(first_time_, false))
    setObsolete(std::all_of(changes_.begin(), changes_.end(),
                            [](const AnchorChange& change) { return change.before == change.after; }));
}

void EditAnchorsCommand::undo() {
  ChangeEvent event;
  event.by_history = true;
  document_.applyAnchorChanges(map_, changes_, next_id_before_, ProjectDocument::Direction::kUndo, event);
}

int EditAnchorsCommand::id() const {
  return gesture_ == kNoGesture ? -1 : kEditAnchorsCommandId;
}

bool EditAnchorsCommand::mergeWith(const QUndoCommand* next) {
  const auto* step = static_cast<const EditAnchorsCommand*>(next);  // the same id(), so the same type
  if (step->gesture_ != gesture_ || step->map_ != map_ || step->changes_.size() != changes_.size()) return false;
  for (std::size_t i = 0; i < changes_.size(); ++i)
    if (step->changes_[i].id() != changes_[i].id() || step->changes_[i].index != changes_[i].index) return false;
  bool same = true;
  for (std::size_t i = 0; i < changes_.size(); ++i) {
    changes_[i].after = step->changes_[i].after;
    changes_[i].snapped_after = step->changes_[i].snapped_after;
    same = same && changes_[i].before == changes_[i].after;
  }
  setObsolete(same);
  return true;
}

namespace edit {
namespace {

QString text(const char* source) {
  return QCoreApplication::translate("edit", source);
}

QString text(const char* source, AnchorId id) {
  return text(source).arg(id);
}

/// Pushes one step that gives each named anchor the value that `change` makes of it.
void push(ProjectDocument& document, const std::vector<AnchorId>& ids, const QString& text,
          const std::function<void(Anchor&)>& change, int gesture = EditAnchorsCommand::kNoGesture,
          bool interim = false, bool always = false, bool snapped = false) {
  std::vector<AnchorChange> changes;
  const AnchorList& anchors = document.anchors();
  for (std::size_t i = 0; i < anchors.size(); ++i) {
    if (std::find(ids.begin(), ids.end(), anchors[i].id) == ids.end()) continue;
    AnchorChange edited{i, anchors[i], anchors[i], false, false};
    change(*edited.after);
    if (edited.after == edited.before && !always) continue;
    edited.snapped_before = document.isSnapped(anchors[i].id);
    const bool moved =
        edited.after->in_blueprint != edited.before->in_blueprint || edited.after->in_slam != edited.before->in_slam;
    edited.snapped_after = moved || always ? snapped : edited.snapped_before;
    changes.push_back(std::move(edited));
  }
  if (changes.empty() || !document.mayEditAnchors()) return;
  document.undoStack().push(
      new EditAnchorsCommand(document, std::move(changes), document.state().next_id, text, gesture, interim));
}

}  // namespace

AnchorId addAnchor(ProjectDocument& document, const Eigen::Vector2d& in_blueprint, const Eigen::Vector2d& in_slam,
                   bool snapped) {
  const AnchorId id = document.nextId();
  if (!document.currentMap() || !document.mayEditAnchors()) return id;
  AnchorChange change;
  change.index = document.anchors().size();
  change.after = Anchor{id, in_blueprint, in_slam, true, {}, {}};
  change.snapped_after = snapped;
  document.undoStack().push(new EditAnchorsCommand(document, {change}, std::max(document.state().next_id, id + 1),
                                                   text(QT_TRANSLATE_NOOP("edit", "add anchor %1"), id)));
  return id;
}

void moveAnchor(ProjectDocument& document, AnchorId id, Side side, const Eigen::Vector2d& to, int gesture, bool interim,
                bool snapped) {
  // The last step of a gesture is pushed even where nothing moved: it asks for the full answer.
  push(
      document, {id}, text(QT_TRANSLATE_NOOP("edit", "move anchor %1"), id),
      [&](Anchor& anchor) { half(anchor, side) = to; }, gesture, interim, !interim, snapped);
}

void setCoordinates(ProjectDocument& document, AnchorId id, const Eigen::Vector2d& in_blueprint,
                    const Eigen::Vector2d& in_slam) {
  push(document, {id}, text(QT_TRANSLATE_NOOP("edit", "type coordinates of anchor %1"), id), [&](Anchor& anchor) {
    anchor.in_blueprint = in_blueprint;
    anchor.in_slam = in_slam;
  });
}

void deleteAnchors(ProjectDocument& document, const std::vector<AnchorId>& ids) {
  std::vector<AnchorChange> changes;
  const AnchorList& anchors = document.anchors();
  for (std::size_t i = 0; i < anchors.size(); ++i)
    if (std::find(ids.begin(), ids.end(), anchors[i].id) != ids.end())
      changes.push_back({i, anchors[i], std::nullopt, document.isSnapped(anchors[i].id), false});
  if (changes.empty() || !document.mayEditAnchors()) return;
  const QString name = changes.size() == 1
                           ? text(QT_TRANSLATE_NOOP("edit", "delete anchor %1"), changes.front().id())
                           : text(QT_TRANSLATE_NOOP("edit", "delete %1 anchors"), AnchorId(changes.size()));
  document.undoStack().push(new EditAnchorsCommand(document, std::move(changes), document.state().next_id, name));
}

void setEnabled(ProjectDocument& document, const std::vector<AnchorId>& ids, bool enabled) {
  push(document, ids,
       enabled ? text(QT_TRANSLATE_NOOP("edit", "use anchors")) : text(QT_TRANSLATE_NOOP("edit", "disable anchors")),
       [&](Anchor& anchor) { anchor.enabled = enabled; });
}

void rename(ProjectDocument& document, AnchorId id, const std::string& name) {
  push(document, {id}, text(QT_TRANSLATE_NOOP("edit", "rename anchor %1"), id),
       [&](Anchor& anchor) { anchor.name = name; });
}

void setNote(ProjectDocument& document, AnchorId id, const std::string& note) {
  push(document, {id}, text(QT_TRANSLATE_NOOP("edit", "note on anchor %1"), id),
       [&](Anchor& anchor) { anchor.note = note; });
}

void swapCounterparts(ProjectDocument& document, AnchorId first, AnchorId second) {
  const Anchor* a = document.anchor(first);
  const Anchor* b = document.anchor(second);
  if (!a || !b || a == b) return;
  const Eigen::Vector2d of_first = a->in_slam;
  const Eigen::Vector2d of_second = b->in_slam;
  push(document, {first, second}, text(QT_TRANSLATE_NOOP("edit", "swap anchors %1 and %2")).arg(first).arg(second),
       [&](Anchor& anchor) { anchor.in_slam = anchor.id == first ? of_second : of_first; });
}

std::vector<AnchorId> addAnchors(ProjectDocument& document, AnchorList anchors, const QString& text) {
  std::vector<AnchorId> ids;
  if (!document.currentMap() || anchors.empty() || !document.mayEditAnchors()) return ids;
  std::vector<AnchorChange> changes;
  AnchorId next_id = document.state().next_id;
  std::set<AnchorId> taken;
  for (const Anchor& anchor : document.anchors()) taken.insert(anchor.id);
  for (const Anchor& anchor : anchors)
    if (!taken.contains(anchor.id)) next_id = std::max(next_id, anchor.id + 1);
  for (Anchor& anchor : anchors) {
    if (!taken.insert(anchor.id).second) {
      anchor.id = freeAnchorId(next_id, taken);
      next_id = std::max(next_id, anchor.id + 1);
      taken.insert(anchor.id);
    }
    ids.push_back(anchor.id);
    changes.push_back({document.anchors().size() + changes.size(), std::nullopt, std::move(anchor), false, false});
  }
  document.undoStack().push(new EditAnchorsCommand(document, std::move(changes), next_id, text));
  return ids;
}

}  // namespace edit
}  // namespace cad2slam
