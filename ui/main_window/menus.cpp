// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/main_window/menus.h"

#include "ui/main_window/actions.h"
#include "ui/panels/anchor_panel.h"

#include <QCoreApplication>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QTableView>
#include <QToolBar>

#include <initializer_list>

namespace cad2slam {
namespace {

using enum ActionId;
constexpr ActionId kSeparator = kCount;

QString text(const char* source) {
  return QCoreApplication::translate("Menus", source);
}

template <class MenuOrBar>
void add(MenuOrBar& target, const Actions& actions, std::initializer_list<ActionId> ids) {
  for (const ActionId id : ids) {
    if (id == kSeparator) {
      target.addSeparator();
    } else {
      target.addAction(actions[id]);
    }
  }
}

}  // namespace

Menus buildMenus(QMainWindow& window, const Actions& actions) {
  Menus menus;
  QMenuBar& bar = *window.menuBar();

  QMenu& file = *bar.addMenu(text(QT_TRANSLATE_NOOP("Menus", "&File")));
  add(file, actions, {kNewProject, kOpenProject});
  menus.recent = file.addMenu(text(QT_TRANSLATE_NOOP("Menus", "Open &recent")));
  add(file, actions,
      {kSaveProject, kSaveProjectAs, kSeparator, kOpenBlueprint, kOpenSlamMap, kSeparator, kImportAnchors,
       kExportAnchors, kSeparator, kExportProjector, kInspectProjector, kExportReport, kSeparator, kSettings,
       kSeparator, kQuit});

  QMenu& edit = *bar.addMenu(text(QT_TRANSLATE_NOOP("Menus", "&Edit")));
  add(edit, actions,
      {kUndo, kRedo, kSeparator, kDelete, kToggleEnabled, kRename, kPlaceInMiddle, kTypeAnchor, kSwap, kSeparator,
       kSelectAll, kDisableWorst, kSeparator, kSnap, kLock});

  QMenu& maps = *bar.addMenu(text(QT_TRANSLATE_NOOP("Menus", "&Maps")));
  menus.slam_maps = maps.addMenu(text(QT_TRANSLATE_NOOP("Menus", "SLAM map being &edited")));
  add(maps, actions,
      {kOpenSlamMap, kRenameSlamMap, kRemoveSlamMap, kCopyAnchors, kSeparator, kRescale, kFlip, kSeparator, kSolveAgain,
       kCancelSolve});

  QMenu& view = *bar.addMenu(text(QT_TRANSLATE_NOOP("Menus", "&View")));
  add(view, actions, {kFit,         kActualSize,    kZoomIn,     kZoomOut,      kRotateLeft,  kRotateRight,
                      kRotateReset, kSeparator,     kLink,       kOtherFollows, kFollowOther, kCenterOnSelection,
                      kNextWorst,   kPreviousWorst, kSeparator,  kLoupe,        kMarkers,     kTexts,
                      kMesh,        kResiduals,     kExaggerate, kSeparator,    kPreviewMode, kLessOpaque,
                      kMoreOpaque,  kSwapDirection, kSeparator,  kHighContrast, kNextPart});
  menus.docks = view.addMenu(text(QT_TRANSLATE_NOOP("Menus", "P&anels")));

  QMenu& tools = *bar.addMenu(text(QT_TRANSLATE_NOOP("Menus", "&Tools")));
  add(tools, actions, {kTestPose, kTypePose, kPlanPath, kSeparator, kLoadPoses, kPastePoses, kClearPoses});

  QMenu& help = *bar.addMenu(text(QT_TRANSLATE_NOOP("Menus", "&Help")));
  add(help, actions, {kCheatSheet, kTour, kSeparator, kAbout});
  return menus;
}

void buildToolBar(QMainWindow& window, const Actions& actions) {
  QToolBar* bar = window.addToolBar(text(QT_TRANSLATE_NOOP("Menus", "Main tool bar")));
  bar->setObjectName(QStringLiteral("mainToolBar"));
  bar->setIconSize({22, 22});
  bar->setMovable(false);
  add(*bar, actions,
      {kOpenProject,  kSaveProject, kSeparator, kOpenBlueprint, kOpenSlamMap, kSeparator,   kUndo,
       kRedo,         kSeparator,   kFit,       kActualSize,    kRotateLeft,  kRotateRight, kLink,
       kSeparator,    kSnap,        kLoupe,     kMarkers,       kTexts,       kMesh,        kResiduals,
       kSeparator,    kTestPose,    kPlanPath,  kSeparator,     kPreviewMode, kSeparator,   kExportProjector,
       kExportReport, kSeparator,   kCheatSheet});
}

void fillAnchorToolBar(AnchorPanel& panel, const Actions& actions) {
  add(*panel.toolBar(), actions,
      {kToggleEnabled, kDelete, kSwap, kDisableWorst, kSeparator, kCenterOnSelection, kPreviousWorst, kNextWorst,
       kSeparator, kLock});
  QTableView* table = panel.table();
  table->setContextMenuPolicy(Qt::CustomContextMenu);
  QObject::connect(table, &QWidget::customContextMenuRequested, table, [table, &actions](const QPoint& at) {
    if (!table->selectionModel()->hasSelection()) return;
    QMenu menu(table);
    fillAnchorMenu(menu, actions);
    menu.exec(table->viewport()->mapToGlobal(at));
  });
}

void fillAnchorMenu(QMenu& menu, const Actions& actions) {
  add(menu, actions, {kCenterOnSelection, kToggleEnabled, kRename, kTypeAnchor, kSwap, kSeparator, kDelete});
}

void fillViewMenu(QMenu& menu, const Actions& actions) {
  add(menu, actions, {kFit, kActualSize, kRotateReset, kSeparator, kTypeAnchor, kSeparator, kOtherFollows});
}

}  // namespace cad2slam
