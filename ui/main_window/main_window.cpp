// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/main_window/main_window.h"

#include "cad2slam/geometry/angle.h"
#include "ui/convert.h"
#include "ui/document/project_commands.h"
#include "ui/engine_sentences.h"
#include "ui/main_window/anchor_editing.h"
#include "ui/main_window/diagnosis_messages.h"
#include "ui/main_window/dropped_files.h"
#include "ui/main_window/exports.h"
#include "ui/main_window/hints.h"
#include "ui/main_window/menus.h"
#include "ui/main_window/part_focus.h"
#include "ui/main_window/preview_wiring.h"
#include "ui/main_window/program_actions.h"
#include "ui/main_window/project_files.h"
#include "ui/main_window/recovery.h"
#include "ui/main_window/stored_view.h"
#include "ui/main_window/tips.h"
#include "ui/main_window/view_pair.h"
#include "ui/models/number_text.h"
#include "ui/panels/anchor_panel.h"
#include "ui/panels/message_bar.h"
#include "ui/panels/preview_panel.h"
#include "ui/panels/status_strip.h"
#include "ui/panels/toast_overlay.h"
#include "ui/tools/test_poses.h"
#include "ui/views/map_view.h"

#include <QCloseEvent>
#include <QComboBox>
#include <QDockWidget>
#include <QInputDialog>
#include <QLabel>
#include <QMenu>
#include <QPixmapCache>
#include <QSettings>
#include <QSplitter>
#include <QStatusBar>
#include <QTableView>
#include <QToolBar>
#include <QVBoxLayout>

namespace cad2slam {

using enum ActionId;

namespace {

constexpr int kPixmapCache_kB = 32 * 1024;
constexpr int kWidestChoice_px = 400;  // names can have any length

/// A view under its heading.
QWidget* titled(const QString& title, QWidget* extra, MapView* view) {
  auto* pane = new QWidget;
  auto* heading = new QHBoxLayout;
  heading->setContentsMargins(8, 2, 8, 2);
  heading->setSpacing(8);
  auto* label = new QLabel(title);
  QFont bold = label->font();
  bold.setBold(true);
  label->setFont(bold);
  label->setBuddy(view);
  heading->addWidget(label);
  if (extra) heading->addWidget(extra);
  heading->addStretch(1);
  auto* layout = new QVBoxLayout(pane);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  // Both headings are as high as one with a choice in it, so that the views are level.
  heading->addStrut(QComboBox().sizeHint().height());
  layout->addLayout(heading);
  layout->addWidget(view, 1);
  return pane;
}

}  // namespace

MainWindow::MainWindow(QWidget* parent) : QMainWindow(parent), actions_(new Actions(this)) {
  // Names of hundreds of anchors on a fine screen; with less they would be drawn anew for every frame.
  QPixmapCache::setCacheLimit(std::max(QPixmapCache::cacheLimit(), kPixmapCache_kB));
  layOut();
  connectFileActions();
  connectViewActions();
  connectSession();
  connectTestPoses();
  connectProgramActions(*this);
  const QSettings settings;
  restoreGeometry(settings.value(QStringLiteral("window_geometry")).toByteArray());
  restoreState(settings.value(QStringLiteral("window_state")).toByteArray());
  refreshTitle();
  refreshMapChoice();
  refreshDropZones();
  refreshStatus();
}

MainWindow::~MainWindow() {
  // The widgets look at the session to their last moment: a cell being edited, for one, is written when it loses focus.
  hide();
  delete anchor_dock_;
  delete preview_dock_;
  delete takeCentralWidget();
}

MapView& MainWindow::view(Side side) {
  return side == Side::kBlueprint ? *blueprint_view_ : *slam_view_;
}

MapView& MainWindow::activeView() {
  return preview_->view().hasFocus() ? preview_->view() : views_->activeView();
}

void MainWindow::layOut() {
  resize(1360, 860);
  blueprint_view_ = new MapView;
  blueprint_view_->setObjectName(QStringLiteral("blueprintView"));
  blueprint_view_->setAccessibleName(tr("Blueprint"));
  slam_view_ = new MapView;
  slam_view_->setObjectName(QStringLiteral("slamView"));
  slam_view_->setAccessibleName(tr("SLAM map"));
  map_choice_ = new QComboBox;
  map_choice_->setObjectName(QStringLiteral("mapChoice"));
  map_choice_->setAccessibleName(tr("SLAM map being edited"));
  map_choice_->setToolTip(tr("SLAM map being edited; each has its own anchors"));
  map_choice_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  map_choice_->setMaximumWidth(kWidestChoice_px);

  auto* splitter = new QSplitter(Qt::Horizontal);
  splitter->setChildrenCollapsible(false);
  splitter->addWidget(titled(tr("Blueprint"), nullptr, blueprint_view_));
  splitter->addWidget(titled(tr("SLAM map"), map_choice_, slam_view_));
  splitter->setSizes({500, 500});
  messages_ = new MessageBar;
  auto* central = new QWidget;
  auto* layout = new QVBoxLayout(central);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(messages_);
  layout->addWidget(splitter, 1);
  setCentralWidget(central);
  messages_->setOverlay(new ToastOverlay(*splitter));

  anchor_panel_ = new AnchorPanel(session_.document(), session_.selection());
  fillAnchorToolBar(*anchor_panel_, *actions_);
  anchor_dock_ = new QDockWidget(tr("Anchors"), this);
  anchor_dock_->setObjectName(QStringLiteral("anchorDock"));
  anchor_dock_->setWidget(anchor_panel_);
  addDockWidget(Qt::BottomDockWidgetArea, anchor_dock_);
  preview_ = new PreviewPanel;
  preview_wiring_ = new PreviewWiring(session_, *preview_, this);
  preview_dock_ = new QDockWidget(tr("Preview"), this);
  preview_dock_->setObjectName(QStringLiteral("previewDock"));
  preview_dock_->setWidget(preview_);
  addDockWidget(Qt::BottomDockWidgetArea, preview_dock_);
  splitDockWidget(anchor_dock_, preview_dock_, Qt::Horizontal);
  resizeDocks({anchor_dock_, preview_dock_}, {300, 300}, Qt::Vertical);
  resizeDocks({anchor_dock_, preview_dock_}, {800, 560}, Qt::Horizontal);

  const Menus menus = buildMenus(*this, *actions_);
  buildToolBar(*this, *actions_);
  menus.docks->addAction(anchor_dock_->toggleViewAction());
  menus.docks->addAction(preview_dock_->toggleViewAction());
  status_ = std::make_unique<StatusStrip>(*statusBar());

  views_ = new ViewPair(session_, *blueprint_view_, *slam_view_, this);
  anchor_editing_ = new AnchorEditing(session_, *actions_, *views_, *anchor_panel_, *messages_, *this);
  files_ = new ProjectFiles(session_, *messages_, *this, *menus.recent);
  exports_ = new Exports(session_, *messages_, *this);
  diagnosis_ = new DiagnosisMessages(session_, *views_, *messages_, this);
  exports_->setFindings([this] { return diagnosis_->sentences(Severity::kWarning); });
  recovery_ = new Recovery(
      session_, *messages_, [this] { return files_->mayClose(); }, this);
  test_poses_ = new TestPoses(session_, this);
  new Tips(session_, *messages_, this);
  QMenu* maps = menus.slam_maps;
  connect(maps, &QMenu::aboutToShow, this, [this, maps] {
    maps->clear();
    for (const ProjectSlamMap& map : session_.document().project().slam_maps) {
      QAction* choice = maps->addAction(toQString(map.name));
      choice->setCheckable(true);
      choice->setChecked(map.name == session_.document().currentMapName());
      connect(choice, &QAction::triggered, this, [this, name = map.name] { session_.document().setCurrentMap(name); });
    }
  });
}

void MainWindow::connectFileActions() {
  const auto on = [&](ActionId id, auto work) { connect((*actions_)[id], &QAction::triggered, this, work); };
  on(kNewProject, [this] { files_->askNew(); });
  on(kOpenProject, [this] { files_->askOpen(); });
  on(kSaveProject, [this] { files_->askSave(); });
  on(kSaveProjectAs, [this] { files_->askSaveAs(); });
  on(kOpenBlueprint, [this] { files_->askImage(Side::kBlueprint); });
  on(kOpenSlamMap, [this] { files_->askImage(Side::kSlam); });
  on(kImportAnchors, [this] { exports_->askImportAnchors(); });
  on(kExportAnchors, [this] { exports_->askExportAnchors(); });
  on(kExportProjector, [this] { exports_->askExportProjector(); });
  on(kInspectProjector, [this] { exports_->askInspectProjector(); });
  on(kQuit, [this] { close(); });
  on(kRenameSlamMap, [this] {
    const std::string name = session_.document().currentMapName();
    const QString given =
        QInputDialog::getText(this, tr("Rename SLAM map"), tr("Name:"), QLineEdit::Normal, toQString(name)).trimmed();
    if (!given.isEmpty() && !edit::renameSlamMap(session_.document(), name, toStd(given)))
      messages_->show(
          {QStringLiteral("toast"), Severity::kWarning, tr("There is already a SLAM map %1").arg(given), {}, 6000});
  });
  on(kRemoveSlamMap, [this] { edit::removeSlamMap(session_.document(), session_.document().currentMapName()); });
  files_->setBeforeSave([this] { storeViewState(); });
  auto* dropped = new DroppedFiles(session_, *files_, *exports_, this);
  connect(views_, &ViewPair::filesDropped, dropped, &DroppedFiles::take);
  for (const Side side : {Side::kBlueprint, Side::kSlam})
    connect(
        &view(side), &MapView::chooseRequested, this,
        [this, side] {
          // A map whose image is still loading, or missing, has been chosen already.
          const ProjectDocument& document = session_.document();
          const bool chosen = side == Side::kBlueprint ? document.hasBlueprint() : document.currentMap() != nullptr;
          if (!chosen) files_->askImage(side);
        },
        Qt::QueuedConnection);
  connect(files_, &ProjectFiles::savedOrOpened, this, &MainWindow::refreshTitle);
}

void MainWindow::connectViewActions() {
  const auto on = [&](ActionId id, auto work) { connect((*actions_)[id], &QAction::triggered, this, work); };
  on(kFit, [this] { activeView().fit(); });
  on(kActualSize, [this] { activeView().showActualSize(); });
  on(kZoomIn, [this] { activeView().zoomBy(1.25); });
  on(kZoomOut, [this] { activeView().zoomBy(0.8); });
  on(kRotateLeft, [this] { rotateActiveView(kPi / 12.0); });
  on(kRotateRight, [this] { rotateActiveView(-kPi / 12.0); });
  on(kRotateReset, [this] { activeView().setRotation(0.0); });
  on(kOtherFollows, [this] { views_->follow(views_->activeSide()); });
  on(kFollowOther, [this] { views_->follow(otherSide(views_->activeSide())); });
  on(kPreviewMode, [this] {
    preview_dock_->show();
    preview_->nextMode();
  });
  on(kLessOpaque, [this] { preview_->changeOpacity(-0.1); });
  on(kMoreOpaque, [this] { preview_->changeOpacity(0.1); });
  on(kSwapDirection, [this] { preview_->swapDirection(); });
  connect(preview_wiring_, &PreviewWiring::failed, this, [this](const QString& sentence) {
    messages_->show({QStringLiteral("preview"), Severity::kWarning, sentence, {}, 8000});
  });
  connect(preview_wiring_, &PreviewWiring::centeringWanted, this, [this](AnchorId id) { views_->centerOn(id); });
  on(kNextPart, [this] { goToNextPart(); });
  on(kSolveAgain, [this] { session_.alignment().solveNow(); });
  on(kCancelSolve, [this] { session_.alignment().cancel(); });
  connect(status_->chip(), &QToolButton::clicked, this,
          [this] { busy_.isShown() ? session_.alignment().cancel() : session_.alignment().solveNow(); });

  const auto toggle = [&](ActionId id, bool checked, auto work) {
    connect((*actions_)[id], &QAction::toggled, this, work);
    (*actions_)[id]->setChecked(checked);
  };
  const auto on_both = [this](auto set) {
    return [this, set](bool on_now) {
      set(*blueprint_view_, on_now);
      set(*slam_view_, on_now);
    };
  };
  const auto on_all = [this, on_both](auto set) {
    return [this, set, both = on_both(set)](bool on_now) {
      both(on_now);
      set(preview_->view(), on_now);
    };
  };
  toggle(kSnap, true, on_both([](MapView& v, bool on_now) { v.setSnapping(on_now); }));
  toggle(kLoupe, false, on_both([](MapView& v, bool on_now) { v.setLoupe(on_now); }));
  toggle(kMarkers, true, on_all([](MapView& v, bool on_now) { v.setMarkersVisible(on_now); }));
  toggle(kTexts, true, on_all([](MapView& v, bool on_now) { v.setMarkerTextVisible(on_now); }));
  toggle(kMesh, false, [this](bool on_now) { views_->setMeshVisible(on_now); });
  toggle(kResiduals, true, [this](bool on_now) { views_->setResidualsVisible(on_now); });
  toggle(kExaggerate, false, [this](bool on_now) { views_->setMagnification(on_now ? 10.0 : 1.0); });
  toggle(kLink, false, [this](bool on_now) { views_->setLinked(on_now); });
  connect(&preview_->view(), &MapView::cancelRequested, views_, &ViewPair::cancelOrDeselect);
  connect(blueprint_view_, &MapView::loupeChanged, (*actions_)[kLoupe], &QAction::setChecked);
  connect(slam_view_, &MapView::loupeChanged, (*actions_)[kLoupe], &QAction::setChecked);

  connect(views_, &ViewPair::cursorMoved, this, &MainWindow::showReadout);
  connect(views_, &ViewPair::cursorLeft, this, [this] { status_->setReadout({}); });
  connect(views_, &ViewPair::anchorMenuRequested, this, [this](AnchorId, const QPoint& at) {
    QMenu menu(this);
    fillAnchorMenu(menu, *actions_);
    menu.exec(at);
  });
  connect(views_, &ViewPair::menuRequested, this, [this](Side, const QPointF&, const QPoint& at) {
    QMenu menu(this);
    fillViewMenu(menu, *actions_);
    menu.exec(at);
  });
}

void MainWindow::connectSession() {
  connect(&session_.document(), &ProjectDocument::changed, this, [this](const ChangeEvent& event) {
    if (event.what & Change::kEverything) views_restored_ = false;
    if (event.what & (Change::kEverything | Change::kSlamMaps | Change::kCurrentMap)) refreshMapChoice();
    refreshTitle();
    refreshDropZones();
    refreshActions();
    refreshStatus();
    refreshTable();
  });
  connect(&session_, &Session::judged, this, [this] {
    refreshTable();
    refreshStatus();
  });
  connect(&session_.alignment(), &Alignment::othersChanged, this, &MainWindow::refreshStatus);
  connect(&busy_, &BusyDelay::becameLong, this, [this] {
    refreshTable();
    refreshStatus();
  });
  connect(&session_.alignment(), &Alignment::progressed, this, [this](int iteration) {
    if (session_.alignment().status() == AlignmentStatus::kSolving && busy_.isShown())
      status_->setChip(tr("solving, step %1").arg(iteration), ChipLook::kBusy);
  });
  connect(&session_.alignment(), &Alignment::statusChanged, this, [this] {
    refreshStatus();
    refreshTable();
    const auto& error = session_.alignment().error();
    if (session_.alignment().status() == AlignmentStatus::kFailed && error) {
      QString text = toSentence(*error);
      if (session_.alignment().result()) text += QStringLiteral(". ") + tr("What you see is the last good result");
      messages_->show({QStringLiteral("solve"), Severity::kError, text, {}, 0});
    } else if (session_.alignment().status() == AlignmentStatus::kUpToDate ||
               session_.alignment().status() == AlignmentStatus::kNoAnchors) {
      messages_->remove(QStringLiteral("solve"));
    }
  });
  connect(&session_.rasters(), &RasterStore::changed, this, [this](Side side) {
    anchor_panel_->model().setFrame(side, session_.rasters().frame(side));
    if (session_.isReady() && !views_restored_) restoreViewState();
    refreshDropZones();
    refreshActions();
    refreshStatus();
  });
  connect(map_choice_, &QComboBox::activated, this,
          [this](int at) { session_.document().setCurrentMap(toStd(map_choice_->itemText(at))); });
  connect(&session_.flow(), &PlaceAnchorFlow::completed, this, [this](AnchorId id) { session_.selection().set({id}); });
}

void MainWindow::connectTestPoses() {
  const auto refresh = [this] {
    for (const Side side : {Side::kBlueprint, Side::kSlam}) {
      view(side).setPoses(test_poses_->glyphs(side));
      view(side).setPaths(test_poses_->paths(side));
    }
    (*actions_)[kClearPoses]->setEnabled(test_poses_->hasPoses());
    refreshHint();
  };
  connect(test_poses_, &TestPoses::changed, this, refresh);
  connect(test_poses_, &TestPoses::forgotten, this, [this] {
    for (const ActionId id : {kTestPose, kPlanPath}) (*actions_)[id]->setChecked(false);
  });
  connect(test_poses_, &TestPoses::planningFailed, this, [this](const QString& sentence) {
    messages_->show({QStringLiteral("plan"), Severity::kWarning, sentence, {}, 6000});
  });
  connect(test_poses_, &TestPoses::planningOver, this, [this] { messages_->remove(QStringLiteral("plan")); });
  connect(views_, &ViewPair::poseDragged, test_poses_, &TestPoses::drag);
  connect(views_, &ViewPair::poseTurned, test_poses_, &TestPoses::turn);
  // Not under an anchor that was just looked at.
  const auto place = [this](double across) {
    constexpr double kAway_px = 40.0;
    const QPointF at(across * blueprint_view_->width(), 0.5 * blueprint_view_->height());
    return test_poses_->freePlaceNear(blueprint_view_->metresFromWidget(at),
                                      kAway_px * blueprint_view_->viewState().m_per_px);
  };
  connect((*actions_)[kTestPose], &QAction::toggled, this, [this, place](bool on_now) {
    test_poses_->setRobotVisible(on_now, [&] { return place(0.5); });
    for (const Side side : {Side::kBlueprint, Side::kSlam})
      if (const auto robot = test_poses_->robotIn(side); on_now && robot)
        views_->bringIntoView(side, toQPointF(robot->translation));
  });
  connect((*actions_)[kPlanPath], &QAction::toggled, this, [this, place](bool on_now) {
    if (on_now) (*actions_)[kTestPose]->setChecked(true);
    test_poses_->setPathVisible(on_now, [&] { return place(0.75); });
  });
  connect((*actions_)[kLoadPoses], &QAction::triggered, this, [this] { askPoses(*this); });
  connect((*actions_)[kPastePoses], &QAction::triggered, this, [this] { pastePoses(*this); });
  connect((*actions_)[kClearPoses], &QAction::triggered, test_poses_, &TestPoses::clearPoses);
  refresh();
}

void MainWindow::refreshTitle() {
  const std::filesystem::path& path = session_.document().path();
  setWindowTitle((path.empty() ? tr("New project") : toQString(path.filename())) + QStringLiteral("[*] – CAD2SLAM"));
  setWindowModified(session_.document().isModified());
}

void MainWindow::refreshActions() {
  anchor_editing_->refreshActions();
  const ProjectDocument& document = session_.document();
  const bool has_map = document.currentMap() != nullptr;
  for (const ActionId id : {kRenameSlamMap, kRemoveSlamMap, kImportAnchors}) (*actions_)[id]->setEnabled(has_map);
  (*actions_)[kExportAnchors]->setEnabled(!document.anchors().empty());
}

void MainWindow::refreshHint() {
  // The read-out belongs to the cursor; where the robot is goes where the eye is while it is dragged.
  const bool robot = test_poses_->isRobotVisible() && !session_.flow().half();
  status_->setHint(robot ? test_poses_->sentence() : hintOf(session_));
}

void MainWindow::refreshStatus() {
  refreshHint();
  const bool busy = session_.alignment().status() == AlignmentStatus::kSolving || session_.alignment().areOthersBusy();
  busy_.setBusy(busy);
  (*actions_)[kCancelSolve]->setEnabled(busy);
  if (!busy_.isBrief()) {
    const ChipState chip = chipOf(session_);
    status_->setChip(chip.text, chip.look);
    status_->chip()->setToolTip(chip.tooltip);
  }
  for (const ActionId id : {kLink, kOtherFollows, kFollowOther})
    (*actions_)[id]->setEnabled(session_.alignment().result() != nullptr);
}

void MainWindow::refreshTable() {
  const bool stale = !session_.alignment().isCurrent() && !busy_.isBrief();
  anchor_panel_->model().setJudgements(session_.judgements(), stale);
  anchor_panel_->setSummary(session_.summary(), stale);
}

void MainWindow::refreshMapChoice() {
  const QSignalBlocker quiet(map_choice_);
  map_choice_->clear();
  for (const ProjectSlamMap& map : session_.document().project().slam_maps) map_choice_->addItem(toQString(map.name));
  map_choice_->setCurrentText(toQString(session_.document().currentMapName()));
  map_choice_->setVisible(map_choice_->count() > 0);
}

void MainWindow::refreshDropZones() {
  const ProjectDocument& document = session_.document();
  const auto text = [&](bool chosen, const QString& invitation) {
    if (!chosen) return invitation;
    return session_.rasters().isLoading() ? tr("Loading...") : tr("This image cannot be shown: see the message above");
  };
  blueprint_view_->setEmptyText(
      text(document.hasBlueprint(),
           tr("Drop the blueprint here, or click to choose it:\na map YAML, PNG, JPG, PGM or TIFF")));
  slam_view_->setEmptyText(text(document.currentMap() != nullptr,
                                tr("Drop the SLAM map here, or click to choose it:\na map YAML, PGM, PNG or TIFF")));
}

void MainWindow::showReadout(Side side, const QPointF& point_m, const QPointF& image_px) {
  status_->setReadout(tr("%1  x %2 m  y %3 m   pixel %4")
                          .arg(side == Side::kBlueprint ? tr("Blueprint") : tr("SLAM map"), metresText(point_m.x()),
                               metresText(point_m.y()), pairText(image_px.x(), image_px.y(), 1)));
}

void MainWindow::rotateActiveView(double by_rad) {
  MapView& view = activeView();
  view.setRotation(view.viewState().rotation_rad + by_rad);
}

void MainWindow::goToNextPart() {
  focusNextPart({blueprint_view_, slam_view_, anchor_panel_->table(), &preview_->view()});
}

void MainWindow::storeViewState() {
  if (!views_restored_) return;  // the images are not there yet: what was stored stays
  QJsonObject views = session_.document().viewState();
  views.insert(QStringLiteral("blueprint"), storedView(*blueprint_view_));
  views.insert(QStringLiteral("slam"), storedView(*slam_view_));
  views.insert(QStringLiteral("slam_maps"), views_->seenMaps());
  session_.document().setViewState(views);
}

void MainWindow::restoreViewState() {
  views_restored_ = true;
  const QJsonObject& views = session_.document().viewState();
  restoreView(*blueprint_view_, views[u"blueprint"].toObject());
  restoreView(*slam_view_, views[u"slam"].toObject());
  views_->setSeenMaps(views[u"slam_maps"].toObject());
}

void MainWindow::keyPressEvent(QKeyEvent* event) {
  // Wherever the keyboard is, Esc drops a half anchor; it never closes the window.
  if (event->key() == Qt::Key_Escape && session_.flow().cancel()) return event->accept();
  QMainWindow::keyPressEvent(event);
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (QWidget* editing = focusWidget()) editing->clearFocus();  // what is being typed counts
  if (files_->mayClose()) {
    recovery_->autosave().clear();
    QSettings settings;
    settings.setValue(QStringLiteral("window_geometry"), saveGeometry());
    settings.setValue(QStringLiteral("window_state"), saveState());
    event->accept();
  } else {
    event->ignore();
  }
}

}  // namespace cad2slam
