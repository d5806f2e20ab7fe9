// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/main_window/actions.h"

#include "ui/views/icons.h"

#include <QKeySequence>
#include <QWidget>

namespace cad2slam {
namespace {

struct Spec {
  ActionId id;
  const char* text;
  const char* tip;
  const char* keys;  // separated by blanks
  const char* icon;  // in :/icons, or nullptr
  bool checkable = false;
};

using enum ActionId;
constexpr Spec kSpecs[] = {
    {kNewProject, QT_TRANSLATE_NOOP("cad2slam::Actions", "&New project"),
     QT_TRANSLATE_NOOP("cad2slam::Actions", "Start with an empty project"), "Ctrl+N", "new"},
    {kOpenProject, QT_TRANSLATE_NOOP("cad2slam::Actions", "&Open project..."),
     QT_TRANSLATE_NOOP("cad2slam::Actions", "Open a project file"), "Ctrl+O", "open"},
    {kSaveProject, QT_TRANSLATE_NOOP("cad2slam::Actions", "&Save project"),
     QT_TRANSLATE_NOOP("cad2slam::Actions", "Save the project"), "Ctrl+S", "save"},
    {kSaveProjectAs, QT_TRANSLATE_NOOP("cad2slam::Actions", "Save project &as..."),
     QT_TRANSLATE_NOOP("cad2slam::Actions", "Save the project under another name"), "Ctrl+Shift+S", nullptr},
    {kOpenBlueprint, QT_TRANSLATE_NOOP("cad2slam::Actions", "Choose &blueprint..."),
     QT_TRANSLATE_NOOP("cad2slam::Actions", "Choose the plan of the building: a map YAML or an image"), "",
     "blueprint"},
    {kOpenSlamMap, QT_TRANSLATE_NOOP("cad2slam::Actions", "Add SLAM &map..."),
     QT_TRANSLATE_NOOP("cad2slam::Actions", "Add a robot's map: a map YAML or an image"), "", "slam_map"},
    {kImportAnchors, QT_TRANSLATE_NOOP("cad2slam::Actions", "&Import anchors..."),
     QT_TRANSLATE_NOOP("cad2slam::Actions", "Read anchors from a CSV file"), "Ctrl+I", nullptr},
    {kExportAnchors, QT_TRANSLATE_NOOP("cad2slam::Actions", "Export an&chors..."),
     QT_TRANSLATE_NOOP("cad2slam::Actions", "Write the anchors to a CSV file"), "Ctrl+Shift+E", nullptr},
    {kExportProjector, QT_TRANSLATE_NOOP("cad2slam::Actions", "&Export projector..."),
     QT_TRANSLATE_NOOP("cad2slam::Actions", "Write the file that robots use"), "Ctrl+E", "export"},
    {kInspectProjector, QT_TRANSLATE_NOOP("cad2slam::Actions", "Inspect a pro&jector..."),
     QT_TRANSLATE_NOOP("cad2slam::Actions", "Tell what a projector file was made from"), "", nullptr},
    {kExportReport, QT_TRANSLATE_NOOP("cad2slam::Actions", "Save &report..."),
     QT_TRANSLATE_NOOP("cad2slam::Actions", "Write a report with pictures as PDF"), "", "report"},
    {kSettings, QT_TRANSLATE_NOOP("cad2slam::Actions", "Se&ttings..."),
     QT_TRANSLATE_NOOP("cad2slam::Actions", "Solver, limits and appearance"), "Ctrl+,", "settings"},
    {kQuit, QT_TRANSLATE_NOOP("cad2slam::Actions", "&Quit"),
     QT_TRANSLATE_NOOP("cad2slam::Actions", "Close the program"), "Ctrl+Q", nullptr},
    {kUndo, QT_TRANSLATE_NOOP("cad2slam::Actions", "&Undo"),
     QT_TRANSLATE_NOOP("cad2slam::Actions", "Take back the last step"), "Ctrl+Z", "undo"},
    {kRedo, QT_TRANSLATE_NOOP("cad2slam::Actions", "&Redo"),
     QT_TRANSLATE_NOOP("cad2slam::Actions", "Do the step again"), "Ctrl+Shift+Z Ctrl+Y", "redo"},
    {kDelete, QT_TRANSLATE_NOOP("cad2slam::Actions", "&Delete"),
     QT_TRANSLATE_NOOP("cad2slam::Actions", "Delete the selected anchors"), "Del Backspace", "delete"},
    {kToggleEnabled, QT_TRANSLATE_NOOP("cad2slam::Actions", "&Use / do not use"),
     QT_TRANSLATE_NOOP("cad2slam::Actions", "Switch the selected anchors on or off"), "X", "toggle"},
    {kRename, QT_TRANSLATE_NOOP("cad2slam::Actions", "Re&name..."),
     QT_TRANSLATE_NOOP("cad2slam::Actions", "Give the selected anchor a name"), "F2", nullptr},
    {kTypeAnchor, QT_TRANSLATE_NOOP("cad2slam::Actions", "&Type coordinates..."),
     QT_TRANSLATE_NOOP("cad2slam::Actions", "Add an anchor, or change the selected one, by numbers"), "Ctrl+T",
     nullptr},
    {kPlaceInMiddle, QT_TRANSLATE_NOOP("cad2slam::Actions", "Place a &point in the middle"),
     QT_TRANSLATE_NOOP("cad2slam::Actions", "As a click in the middle of the view, where the arrow keys have moved it"),
     "Ins", nullptr},
    {kSwap, QT_TRANSLATE_NOOP("cad2slam::Actions", "S&wap counterparts"),
     QT_TRANSLATE_NOOP("cad2slam::Actions", "Exchange the SLAM points of the two selected anchors"), "", "swap"},
    {kSelectAll, QT_TRANSLATE_NOOP("cad2slam::Actions", "Select &all"),
     QT_TRANSLATE_NOOP("cad2slam::Actions", "Select all anchors"), "Ctrl+A", nullptr},
    {kDisableWorst, QT_TRANSLATE_NOOP("cad2slam::Actions", "Disable &worst"),
     QT_TRANSLATE_NOOP("cad2slam::Actions", "Do not use the anchor with the largest error"), "", "bad"},
    {kLock, QT_TRANSLATE_NOOP("cad2slam::Actions", "&Lock anchors"),
     QT_TRANSLATE_NOOP("cad2slam::Actions", "Look only: no anchor can be changed"), "K", "lock", true},
    {kSnap, QT_TRANSLATE_NOOP("cad2slam::Actions", "&Snap to corners"),
     QT_TRANSLATE_NOOP("cad2slam::Actions", "Clicks go to the corner that is shown; hold Alt to suspend"), "S", "snap",
     true},
    {kRescale, QT_TRANSLATE_NOOP("cad2slam::Actions", "&Rescale blueprint..."),
     QT_TRANSLATE_NOOP("cad2slam::Actions", "Correct the scale of the blueprint; anchors keep their places"), "",
     nullptr},
    {kFlip, QT_TRANSLATE_NOOP("cad2slam::Actions", "&Mirror blueprint"),
     QT_TRANSLATE_NOOP("cad2slam::Actions", "Mirror the blueprint left to right; anchors keep their places"), "",
     nullptr},
    {kRenameSlamMap, QT_TRANSLATE_NOOP("cad2slam::Actions", "Rename SLAM map..."),
     QT_TRANSLATE_NOOP("cad2slam::Actions", "Give the SLAM map another name"), "", nullptr},
    {kRemoveSlamMap, QT_TRANSLATE_NOOP("cad2slam::Actions", "Remove SLAM map"),
     QT_TRANSLATE_NOOP("cad2slam::Actions", "Take this SLAM map and its anchors out of the project"), "", nullptr},
    {kCopyAnchors, QT_TRANSLATE_NOOP("cad2slam::Actions", "&Copy anchors from..."),
     QT_TRANSLATE_NOOP("cad2slam::Actions", "Take over the blueprint points of another SLAM map's anchors"), "",
     nullptr},
    {kFit, QT_TRANSLATE_NOOP("cad2slam::Actions", "&Fit"),
     QT_TRANSLATE_NOOP("cad2slam::Actions", "Show the whole picture"), "F", "fit"},
    {kActualSize, QT_TRANSLATE_NOOP("cad2slam::Actions", "&100 %"),
     QT_TRANSLATE_NOOP("cad2slam::Actions", "One image pixel for each screen pixel"), "1", "actual_size"},
    {kZoomIn, QT_TRANSLATE_NOOP("cad2slam::Actions", "Zoom &in"),
     QT_TRANSLATE_NOOP("cad2slam::Actions", "Show less, larger"), "+ =", "zoom_in"},
    {kZoomOut, QT_TRANSLATE_NOOP("cad2slam::Actions", "Zoom &out"),
     QT_TRANSLATE_NOOP("cad2slam::Actions", "Show more, smaller"), "-", "zoom_out"},
    {kRotateLeft, QT_TRANSLATE_NOOP("cad2slam::Actions", "Turn &left"),
     QT_TRANSLATE_NOOP("cad2slam::Actions", "Turn this view by 15 degrees to the left"), ",", "rotate_left"},
    {kRotateRight, QT_TRANSLATE_NOOP("cad2slam::Actions", "Turn &right"),
     QT_TRANSLATE_NOOP("cad2slam::Actions", "Turn this view by 15 degrees to the right"), ".", "rotate_right"},
    {kRotateReset, QT_TRANSLATE_NOOP("cad2slam::Actions", "Turn &back"),
     QT_TRANSLATE_NOOP("cad2slam::Actions", "Show this view upright again"), "0", nullptr},
    {kCenterOnSelection, QT_TRANSLATE_NOOP("cad2slam::Actions", "&Centre on anchor"),
     QT_TRANSLATE_NOOP("cad2slam::Actions", "Show the selected anchor in the middle of both views"), "D", "center"},
    {kNextWorst, QT_TRANSLATE_NOOP("cad2slam::Actions", "&Next by error"),
     QT_TRANSLATE_NOOP("cad2slam::Actions", "Go to the anchor with the next smaller error"), "N", "next"},
    {kPreviousWorst, QT_TRANSLATE_NOOP("cad2slam::Actions", "&Previous by error"),
     QT_TRANSLATE_NOOP("cad2slam::Actions", "Go to the anchor with the next larger error"), "Shift+N", "previous"},
    {kLink, QT_TRANSLATE_NOOP("cad2slam::Actions", "Lin&k views"),
     QT_TRANSLATE_NOOP("cad2slam::Actions", "Both views show the same place, turned the same way"), "G", "link", true},
    {kOtherFollows, QT_TRANSLATE_NOOP("cad2slam::Actions", "Other view goes &here"),
     QT_TRANSLATE_NOOP("cad2slam::Actions", "The other view shows what this one shows"), "Q", nullptr},
    {kFollowOther, QT_TRANSLATE_NOOP("cad2slam::Actions", "Go where the &other is"),
     QT_TRANSLATE_NOOP("cad2slam::Actions", "This view shows what the other one shows"), "W", nullptr},
    {kLoupe, QT_TRANSLATE_NOOP("cad2slam::Actions", "&Loupe"),
     QT_TRANSLATE_NOOP("cad2slam::Actions", "Magnify what is under the cursor; hold Z for a moment"), "L", "loupe",
     true},
    {kMarkers, QT_TRANSLATE_NOOP("cad2slam::Actions", "&Markers"),
     QT_TRANSLATE_NOOP("cad2slam::Actions", "Show or hide the anchors"), "V", "markers", true},
    {kTexts, QT_TRANSLATE_NOOP("cad2slam::Actions", "&Labels"),
     QT_TRANSLATE_NOOP("cad2slam::Actions", "Show or hide numbers and names"), "T", "labels", true},
    {kMesh, QT_TRANSLATE_NOOP("cad2slam::Actions", "M&esh"),
     QT_TRANSLATE_NOOP("cad2slam::Actions", "Show the mesh; colours tell how much it is stretched"), "M", "mesh", true},
    {kResiduals, QT_TRANSLATE_NOOP("cad2slam::Actions", "Resi&duals"),
     QT_TRANSLATE_NOOP("cad2slam::Actions", "Show what each anchor misses"), "", "residuals", true},
    {kExaggerate, QT_TRANSLATE_NOOP("cad2slam::Actions", "Residuals &x10"),
     QT_TRANSLATE_NOOP("cad2slam::Actions", "Draw residuals ten times as long"), "", nullptr, true},
    {kTestPose, QT_TRANSLATE_NOOP("cad2slam::Actions", "Test &pose"),
     QT_TRANSLATE_NOOP("cad2slam::Actions", "Drag a robot in either view and see it in the other"), "R", "test_pose",
     true},
    {kTypePose, QT_TRANSLATE_NOOP("cad2slam::Actions", "Test pose by &numbers..."),
     QT_TRANSLATE_NOOP("cad2slam::Actions", "Put the robot to x, y and heading in the frame of this view"), "Shift+R",
     nullptr},
    {kLoadPoses, QT_TRANSLATE_NOOP("cad2slam::Actions", "Show poses &from file..."),
     QT_TRANSLATE_NOOP("cad2slam::Actions", "Show a CSV of poses in both views"), "", nullptr},
    {kPastePoses, QT_TRANSLATE_NOOP("cad2slam::Actions", "Show poses from the &clipboard..."),
     QT_TRANSLATE_NOOP("cad2slam::Actions", "Show copied lines x, y, heading in both views"), "Ctrl+Shift+V", nullptr},
    {kClearPoses, QT_TRANSLATE_NOOP("cad2slam::Actions", "&Remove shown poses"),
     QT_TRANSLATE_NOOP("cad2slam::Actions", "Take the poses from file or clipboard away again"), "", nullptr},
    {kPlanPath, QT_TRANSLATE_NOOP("cad2slam::Actions", "Plan a pa&th"),
     QT_TRANSLATE_NOOP("cad2slam::Actions", "Show the way from the first to the second test pose in both views"), "P",
     "path", true},
    {kNextPart, QT_TRANSLATE_NOOP("cad2slam::Actions", "Next part of the window"),
     QT_TRANSLATE_NOOP("cad2slam::Actions", "Go on with the keyboard in the next part of the window"), "F6", nullptr},
    {kSolveAgain, QT_TRANSLATE_NOOP("cad2slam::Actions", "&Solve again"),
     QT_TRANSLATE_NOOP("cad2slam::Actions", "Compute the alignment again"), "F5", nullptr},
    {kCancelSolve, QT_TRANSLATE_NOOP("cad2slam::Actions", "St&op solving"),
     QT_TRANSLATE_NOOP("cad2slam::Actions", "Stop the computation; the last result stays"), "Ctrl+.", nullptr},
    {kPreviewMode, QT_TRANSLATE_NOOP("cad2slam::Actions", "Next preview &mode"),
     QT_TRANSLATE_NOOP("cad2slam::Actions", "Overlay, two inks, swipe, blink, lens, ..."), "O", "preview"},
    {kLessOpaque, QT_TRANSLATE_NOOP("cad2slam::Actions", "&Less overlay"),
     QT_TRANSLATE_NOOP("cad2slam::Actions", "Make the overlay more transparent"), "[", nullptr},
    {kMoreOpaque, QT_TRANSLATE_NOOP("cad2slam::Actions", "M&ore overlay"),
     QT_TRANSLATE_NOOP("cad2slam::Actions", "Make the overlay more opaque"), "]", nullptr},
    {kSwapDirection, QT_TRANSLATE_NOOP("cad2slam::Actions", "Swap preview &direction"),
     QT_TRANSLATE_NOOP("cad2slam::Actions", "Blueprint over SLAM map, or SLAM map over blueprint"), "Shift+O", nullptr},
    {kHighContrast, QT_TRANSLATE_NOOP("cad2slam::Actions", "&High contrast"),
     QT_TRANSLATE_NOOP("cad2slam::Actions", "For bright sunlight"), "", nullptr, true},
    {kCheatSheet, QT_TRANSLATE_NOOP("cad2slam::Actions", "&Keys"),
     QT_TRANSLATE_NOOP("cad2slam::Actions", "All keys on one page"), "F1", "help"},
    {kTour, QT_TRANSLATE_NOOP("cad2slam::Actions", "&Guided tour"),
     QT_TRANSLATE_NOOP("cad2slam::Actions", "A few steps on a sample building"), "", nullptr},
    {kAbout, QT_TRANSLATE_NOOP("cad2slam::Actions", "&About CAD2SLAM"),
     QT_TRANSLATE_NOOP("cad2slam::Actions", "Version and licence"), "", nullptr},
};

}  // namespace

Actions::Actions(QWidget* window) : QObject(window) {
  static_assert(std::size(kSpecs) == static_cast<std::size_t>(ActionId::kCount));
  for (const Spec& spec : kSpecs) {
    auto* action = new QAction(window);
    action->setText(tr(spec.text));
    QList<QKeySequence> keys;
    for (const QString& key : QString::fromLatin1(spec.keys).split(QLatin1Char(' '), Qt::SkipEmptyParts))
      keys.append(QKeySequence::fromString(key, QKeySequence::PortableText));
    action->setShortcuts(keys);
    QString tip = tr(spec.tip);
    if (!keys.isEmpty()) tip += QStringLiteral(" (%1)").arg(keys.front().toString(QKeySequence::NativeText));
    action->setToolTip(tip);
    action->setStatusTip(tip);
    action->setCheckable(spec.checkable);
    if (spec.icon) action->setIcon(icon(QLatin1String(spec.icon)));
    window->addAction(action);
    actions_[static_cast<std::size_t>(spec.id)] = action;
  }
}

}  // namespace cad2slam
