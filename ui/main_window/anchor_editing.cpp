// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/main_window/anchor_editing.h"

#include "ui/convert.h"
#include "ui/dialogs/numbers_dialog.h"
#include "ui/document/anchor_commands.h"
#include "ui/document/project_commands.h"
#include "ui/main_window/view_pair.h"
#include "ui/models/number_text.h"
#include "ui/panels/anchor_panel.h"
#include "ui/panels/message_bar.h"

#include <QInputDialog>
#include <QTableView>

#include <algorithm>

namespace cad2slam {

using enum ActionId;

AnchorEditing::AnchorEditing(Session& session, const Actions& actions, ViewPair& views, AnchorPanel& panel,
                             MessageBar& messages, QWidget& window)
    : QObject(&window),
      session_(session),
      actions_(actions),
      views_(views),
      panel_(panel),
      messages_(messages),
      window_(window) {
  const auto on = [&](ActionId id, auto work) { connect(actions_[id], &QAction::triggered, this, work); };
  on(kUndo, [this] { session_.document().undoStack().undo(); });
  on(kRedo, [this] { session_.document().undoStack().redo(); });
  on(kDelete, [this] { deleteSelected(); });
  on(kToggleEnabled, [this] { toggleSelected(); });
  on(kRename, [this] { renameSelected(); });
  on(kTypeAnchor, [this] { typeCoordinates(); });
  on(kPlaceInMiddle, [this] { views_.view(views_.activeSide()).clickInMiddle(); });
  on(kSwap, [this] { swapSelected(); });
  on(kSelectAll, [this] {
    std::vector<AnchorId> ids;
    for (const Anchor& anchor : session_.document().anchors()) ids.push_back(anchor.id);
    session_.selection().set(std::move(ids));
  });
  on(kDisableWorst, [this] { disableWorst(); });
  on(kRescale, [this] { rescale(); });
  on(kFlip, [this] { flip(); });
  on(kCopyAnchors, [this] { copyAnchors(); });
  on(kCenterOnSelection, [this] {
    if (const auto id = session_.selection().current()) views_.centerOn(*id);
  });
  on(kNextWorst, [this] { goToNextWorst(true); });
  on(kPreviousWorst, [this] { goToNextWorst(false); });
  connect(actions_[kLock], &QAction::toggled, this, [this](bool locked) { session_.document().setLocked(locked); });
  connect(&views_, &ViewPair::deleteRequested, this, &AnchorEditing::deleteSelected);
  connect(&panel_, &AnchorPanel::toggleRequested, this, &AnchorEditing::toggleSelected);
  connect(&panel_, &AnchorPanel::jumpRequested, &views_, &ViewPair::centerOn);

  QUndoStack& stack = session_.document().undoStack();
  connect(&stack, &QUndoStack::canUndoChanged, this, &AnchorEditing::refreshActions);
  connect(&stack, &QUndoStack::canRedoChanged, this, &AnchorEditing::refreshActions);
  connect(&stack, &QUndoStack::indexChanged, this, &AnchorEditing::refreshActions);
  connect(&session_.selection(), &AnchorSelection::changed, this, &AnchorEditing::refreshActions);
  connect(&session_.document(), &ProjectDocument::changed, this, &AnchorEditing::refreshActions);
  connect(&session_.document(), &ProjectDocument::editRefused, this, [this] {
    messages_.show({QStringLiteral("toast"),
                    Severity::kNote,
                    tr("Anchors are locked for looking only"),
                    {{tr("Unlock"),
                      [this] {
                        session_.document().setLocked(false);
                        messages_.remove(QStringLiteral("toast"));
                      }}},
                    5000});
  });
  refreshActions();
}

void AnchorEditing::refreshActions() {
  ProjectDocument& document = session_.document();
  QUndoStack& stack = document.undoStack();
  const bool editable = !document.isLocked();
  actions_[kUndo]->setEnabled(editable && stack.canUndo());
  actions_[kRedo]->setEnabled(editable && stack.canRedo());
  actions_[kUndo]->setText(stack.canUndo() ? tr("&Undo: %1").arg(stack.undoText()) : tr("&Undo"));
  actions_[kRedo]->setText(stack.canRedo() ? tr("&Redo: %1").arg(stack.redoText()) : tr("&Redo"));
  const std::size_t selected = session_.selection().ids().size();
  for (const ActionId id : {kDelete, kToggleEnabled}) actions_[id]->setEnabled(editable && selected > 0);
  actions_[kRename]->setEnabled(editable && selected == 1);
  actions_[kSwap]->setEnabled(editable && selected == 2);
  actions_[kTypeAnchor]->setEnabled(editable && session_.isReady());
  actions_[kPlaceInMiddle]->setEnabled(editable && session_.isReady());
  actions_[kCenterOnSelection]->setEnabled(selected > 0);
  const bool any = !document.anchors().empty();
  for (const ActionId id : {kSelectAll, kNextWorst, kPreviousWorst}) actions_[id]->setEnabled(any);
  actions_[kDisableWorst]->setEnabled(editable && any);
  for (const ActionId id : {kRescale, kFlip}) actions_[id]->setEnabled(editable && document.hasBlueprint());
  actions_[kCopyAnchors]->setEnabled(editable && document.project().slam_maps.size() > 1);
  actions_[kLock]->setChecked(document.isLocked());
}

Cure AnchorEditing::undoCure() {
  const int step = session_.document().undoStack().index();
  return {tr("Undo"), [this, step] {
            QUndoStack& stack = session_.document().undoStack();
            if (stack.index() == step && !session_.document().isLocked()) stack.undo();  // else it is not the last step
            messages_.remove(QStringLiteral("toast"));
          }};
}

void AnchorEditing::deleteSelected() {
  if (session_.document().isLocked()) return;
  const std::vector<AnchorId> ids = session_.selection().ids();
  if (ids.empty()) return;
  edit::deleteAnchors(session_.document(), ids);
  messages_.show({QStringLiteral("toast"),
                  Severity::kNote,
                  ids.size() == 1 ? tr("Anchor %1 deleted").arg(ids.front())
                                  : tr("%n anchor(s) deleted", nullptr, int(ids.size())),
                  {undoCure()},
                  5000});
}

void AnchorEditing::toggleSelected() {
  ProjectDocument& document = session_.document();
  if (document.isLocked()) return;
  const std::vector<AnchorId> ids = session_.selection().ids();
  const bool any_used = std::any_of(ids.begin(), ids.end(), [&](AnchorId id) {
    const Anchor* anchor = document.anchor(id);
    return anchor && anchor->enabled;
  });
  edit::setEnabled(document, ids, !any_used);
}

void AnchorEditing::renameSelected() {
  const QModelIndex here = panel_.table()->currentIndex();
  if (panel_.table()->hasFocus() && here.flags().testFlag(Qt::ItemIsEditable)) return panel_.table()->edit(here);
  const auto id = session_.selection().current();
  const std::optional<int> row = id ? panel_.model().rowOf(*id) : std::nullopt;
  if (!row) return;
  // Where the name stands is where it is edited; a dialog for one word would be in the way.
  auto* sorted = static_cast<QSortFilterProxyModel*>(panel_.table()->model());
  const QModelIndex cell = sorted->mapFromSource(panel_.model().index(*row, AnchorTableModel::kName));
  panel_.table()->setFocus();
  panel_.table()->setCurrentIndex(cell);
  panel_.table()->edit(cell);
}

void AnchorEditing::typeCoordinates() {
  ProjectDocument& document = session_.document();
  const auto id = session_.selection().current();
  const Anchor* anchor = id ? document.anchor(*id) : nullptr;
  const auto known = [anchor](Side side, Eigen::Index axis) {
    return anchor ? std::optional(half(*anchor, side)[axis]) : std::nullopt;
  };
  NumbersDialog dialog(
      &window_, anchor ? tr("Coordinates of anchor %1").arg(anchor->id) : tr("New anchor %1").arg(document.nextId()),
      {{tr("Blueprint &x (m):"), known(Side::kBlueprint, 0)},
       {tr("Blueprint &y (m):"), known(Side::kBlueprint, 1)},
       {tr("&SLAM map x (m):"), known(Side::kSlam, 0)},
       {tr("SLAM &map y (m):"), known(Side::kSlam, 1)}});
  if (dialog.exec() != QDialog::Accepted) return;
  const Eigen::Vector2d in_blueprint(dialog.value(0), dialog.value(1));
  const Eigen::Vector2d in_slam(dialog.value(2), dialog.value(3));
  if (anchor) {
    edit::setCoordinates(document, *id, in_blueprint, in_slam);
  } else {
    session_.selection().set({edit::addAnchor(document, in_blueprint, in_slam)});
  }
}

void AnchorEditing::swapSelected() {
  const std::vector<AnchorId>& ids = session_.selection().ids();
  if (ids.size() == 2) edit::swapCounterparts(session_.document(), ids[0], ids[1]);
}

void AnchorEditing::disableWorst() {
  std::optional<std::pair<double, AnchorId>> worst;
  for (const auto& [id, judgement] : session_.judgements()) {
    if (judgement.is_check || !judgement.residual_m) continue;
    const double error = judgement.leave_one_out_m.value_or(*judgement.residual_m);
    if (!worst || error > worst->first) worst = {error, id};
  }
  if (!worst) return;
  edit::setEnabled(session_.document(), {worst->second}, false);
  session_.selection().set({worst->second});
  messages_.show({QStringLiteral("toast"),
                  Severity::kNote,
                  tr("Anchor %1 is no longer used; it was off by %2").arg(worst->second).arg(lengthText(worst->first)),
                  {undoCure()},
                  5000});
}

void AnchorEditing::rescale() {
  const double now = session_.document().project().blueprint.metadata.resolution_m_per_px;
  bool ok = false;
  const QString shown = numberText(now, 6);
  const QString text = QInputDialog::getText(
      &window_, tr("Rescale blueprint"), tr("Metres for each pixel of the blueprint:"), QLineEdit::Normal, shown, &ok);
  if (!ok || text == shown) return;  // left alone, it keeps the digits that are not shown
  const std::optional<double> wanted = parseNumber(text);
  if (!wanted || *wanted <= 0.0) {
    messages_.show(
        {QStringLiteral("toast"), Severity::kWarning, tr("\"%1\" is not a length above zero").arg(text), {}, 6000});
    return;
  }
  if (!kResolutionRange.holds(*wanted)) {
    messages_.show({QStringLiteral("toast"),
                    Severity::kWarning,
                    tr("A pixel can be from %1 to %2 metres wide")
                        .arg(numberText(kResolutionRange.least, 6), numberText(kResolutionRange.most, 0)),
                    {},
                    6000});
    return;
  }
  edit::rescaleBlueprint(session_.document(), *wanted / now);
}

void AnchorEditing::flip() {
  if (const auto& frame = session_.rasters().frame(Side::kBlueprint)) edit::flipBlueprint(session_.document(), *frame);
}

void AnchorEditing::copyAnchors() {
  ProjectDocument& document = session_.document();
  QStringList names;
  for (const ProjectSlamMap& map : document.project().slam_maps)
    if (map.name != document.currentMapName()) names += toQString(map.name);
  bool ok = false;
  const QString name = QInputDialog::getItem(&window_, tr("Copy anchors"), tr("From SLAM map:"), names, 0, false, &ok);
  if (!ok) return;
  AnchorList copies;
  for (const ProjectSlamMap& map : document.project().slam_maps) {
    if (map.name != toStd(name)) continue;
    for (const Anchor& anchor : map.anchors) {
      Anchor copy = anchor;
      // Where the other map has it is only a guess here; the alignment so far knows better.
      if (const auto carried = session_.carry(Side::kBlueprint, toQPointF(anchor.in_blueprint)))
        copy.in_slam = toEigen(carried->point_m);
      copy.enabled = false;
      copy.note = toStd(tr("copied from %1; move its SLAM point to the right place, then switch it on").arg(name));
      copies.push_back(std::move(copy));
    }
  }
  session_.selection().set(edit::addAnchors(document, std::move(copies), tr("copy anchors from %1").arg(name)));
}

void AnchorEditing::goToNextWorst(bool forward) {
  const auto next = panel_.nextByError(session_.selection().current(), forward);
  if (!next) return;
  session_.selection().set({*next});
  views_.centerOn(*next);
}

}  // namespace cad2slam
