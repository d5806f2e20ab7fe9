// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAction>
#include <QObject>

#include <array>

namespace cad2slam {

/// Everything the installer can ask for, once: menus, tool bars, the cheat sheet and tests all use these.
enum class ActionId {
  kNewProject,
  kOpenProject,
  kSaveProject,
  kSaveProjectAs,
  kOpenBlueprint,
  kOpenSlamMap,
  kImportAnchors,
  kExportAnchors,
  kExportProjector,
  kInspectProjector,
  kExportReport,
  kSettings,
  kQuit,
  kUndo,
  kRedo,
  kDelete,
  kToggleEnabled,
  kRename,
  kTypeAnchor,
  kPlaceInMiddle,
  kSwap,
  kSelectAll,
  kDisableWorst,
  kLock,
  kSnap,
  kRescale,
  kFlip,
  kRenameSlamMap,
  kRemoveSlamMap,
  kCopyAnchors,
  kFit,
  kActualSize,
  kZoomIn,
  kZoomOut,
  kRotateLeft,
  kRotateRight,
  kRotateReset,
  kCenterOnSelection,
  kNextWorst,
  kPreviousWorst,
  kLink,
  kOtherFollows,
  kFollowOther,
  kLoupe,
  kMarkers,
  kTexts,
  kMesh,
  kResiduals,
  kExaggerate,
  kTestPose,
  kTypePose,
  kLoadPoses,
  kPastePoses,
  kClearPoses,
  kPlanPath,
  kNextPart,
  kSolveAgain,
  kCancelSolve,
  kPreviewMode,
  kLessOpaque,
  kMoreOpaque,
  kSwapDirection,
  kHighContrast,
  kCheatSheet,
  kTour,
  kAbout,
  kCount,
};

/// Makes the actions with their texts, keys and icons; whoever does the work connects to them.
class Actions : public QObject {
  Q_OBJECT

 public:
  explicit Actions(QWidget* window);

  [[nodiscard]] QAction* operator[](ActionId id) const { return actions_[static_cast<std::size_t>(id)]; }
  [[nodiscard]] const auto& all() const { return actions_; }

 private:
  std::array<QAction*, static_cast<std::size_t>(ActionId::kCount)> actions_{};
};

}  // namespace cad2slam
