// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/main_window/actions.h"

#include <QIcon>
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

#define T(text) QT_TRANSLATE_NOOP("cad2slam::Actions", text)

using enum ActionId;
constexpr Spec kSpecs[] = {
    {kNewProject, T("&New project"), T("Start with an empty project"), "Ctrl+N", "new"},
    {kOpenProject, T("&Open project..."), T("Open a project file"), "Ctrl+O", "open"},
    {kSaveProject, T("&Save project"), T("Save the project"), "Ctrl+S", "save"},
    {kSaveProjectAs, T("Save project &as..."), T("Save the project under another name"), "Ctrl+Shift+S", nullptr},
    {kOpenBlueprint, T("Choose &blueprint..."), T("Choose the plan of the building: a map YAML or an image"), "",
     "blueprint"},
    {kOpenSlamMap, T("Add SLAM &map..."), T("Add a robot's map: a map YAML or an image"), "", "slam_map"},
    {kImportAnchors, T("&Import anchors..."), T("Read anchors from a CSV file"), "Ctrl+I", nullptr},
    {kExportAnchors, T("Export an&chors..."), T("Write the anchors to a CSV file"), "Ctrl+Shift+E", nullptr},
    {kExportProjector, T("&Export projector..."), T("Write the file that robots use"), "Ctrl+E", "export"},
    {kInspectProjector, T("Inspect a pro&jector..."), T("Tell what a projector file was made from"), "", nullptr},
    {kExportReport, T("Save &report..."), T("Write a report with pictures as PDF"), "", "report"},
    {kSettings, T("Se&ttings..."), T("Solver, limits and appearance"), "Ctrl+,", "settings"},
    {kQuit, T("&Quit"), T("Close the program"), "Ctrl+Q", nullptr},
    {kUndo, T("&Undo"), T("Take back the last step"), "Ctrl+Z", "undo"},
    {kRedo, T("&Redo"), T("Do the step again"), "Ctrl+Shift+Z Ctrl+Y", "redo"},
    {kDelete, T("&Delete"), T("Delete the selected anchors"), "Del Backspace", "delete"},
    {kToggleEnabled, T("&Use / do not use"), T("Switch the selected anchors on or off"), "X", "toggle"},
    {kRename, T("Re&name..."), T("Give the selected anchor a name"), "F2", nullptr},
    {kTypeAnchor, T("&Type coordinates..."), T("Add an anchor, or change the selected one, by numbers"), "Ctrl+T",
     nullptr},
    {kSwap, T("S&wap counterparts"), T("Exchange the SLAM points of the two selected anchors"), "", "swap"},
    {kSelectAll, T("Select &all"), T("Select all anchors"), "Ctrl+A", nullptr},
    {kDisableWorst, T("Disable &worst"), T("Do not use the anchor with the largest error"), "", nullptr},
    {kLock, T("&Lock anchors"), T("Look only: no anchor can be changed"), "K", "lock", true},
    {kSnap, T("&Snap to corners"), T("Clicks go to the corner that is shown; hold Alt to suspend"), "S", "snap", true},
    {kRescale, T("&Rescale blueprint..."), T("Correct the scale of the blueprint; anchors keep their places"), "",
     nullptr},
    {kFlip, T("&Mirror blueprint"), T("Mirror the blueprint left to right; anchors keep their places"), "", nullptr},
    {kRenameSlamMap, T("Rename SLAM map..."), T("Give the SLAM map another name"), "", nullptr},
    {kRemoveSlamMap, T("Remove SLAM map"), T("Take this SLAM map and its anchors out of the project"), "", nullptr},
    {kCopyAnchors, T("&Copy anchors from..."), T("Take over the blueprint points of another SLAM map's anchors"), "",
     nullptr},
    {kFit, T("&Fit"), T("Show the whole picture"), "F", "fit"},
    {kActualSize, T("&100 %"), T("One image pixel for each screen pixel"), "1", "actual_size"},
    {kZoomIn, T("Zoom &in"), T("Show less, larger"), "+ =", "zoom_in"},
    {kZoomOut, T("Zoom &out"), T("Show more, smaller"), "-", "zoom_out"},
    {kRotateLeft, T("Turn &left"), T("Turn this view by 15 degrees to the left"), "Ctrl+Left", "rotate_left"},
    {kRotateRight, T("Turn &right"), T("Turn this view by 15 degrees to the right"), "Ctrl+Right", "rotate_right"},
    {kRotateReset, T("Turn &back"), T("Show this view upright again"), "Ctrl+Up", nullptr},
    {kCenterOnSelection, T("&Centre on anchor"), T("Show the selected anchor in the middle of both views"), "D",
     "center"},
    {kNextWorst, T("&Next by error"), T("Go to the anchor with the next smaller error"), "N", "next"},
    {kPreviousWorst, T("&Previous by error"), T("Go to the anchor with the next larger error"), "Shift+N", "previous"},
    {kLink, T("Lin&k views"), T("Both views show the same place, turned the same way"), "G", "link", true},
    {kOtherFollows, T("Other view goes &here"), T("The other view shows what this one shows"), "Q", nullptr},
    {kFollowOther, T("Go where the &other is"), T("This view shows what the other one shows"), "W", nullptr},
    {kLoupe, T("&Loupe"), T("Magnify what is under the cursor; hold Z for a moment"), "L", "loupe", true},
    {kMarkers, T("&Markers"), T("Show or hide the anchors"), "V", "markers", true},
    {kTexts, T("&Labels"), T("Show or hide numbers and names"), "T", "labels", true},
    {kMesh, T("M&esh"), T("Show the mesh; colours tell how much it is stretched"), "M", "mesh", true},
    {kResiduals, T("Resi&duals"), T("Show what each anchor misses"), "", "residuals", true},
    {kExaggerate, T("Residuals &x10"), T("Draw residuals ten times as long"), "", nullptr, true},
    {kTestPose, T("Test &pose"), T("Drag a robot in either view and see it in the other"), "R", "test_pose", true},
    {kLoadPoses, T("Show poses &from file..."), T("Show a CSV of poses in both views"), "", nullptr},
    {kPlanPath, T("Plan a pa&th"), T("Show the way from the first to the second test pose in both views"), "P", "path",
     true},
    {kNextPart, T("Next part of the window"), T("Go on with the keyboard in the next part of the window"), "F6",
     nullptr},
    {kSolveAgain, T("&Solve again"), T("Compute the alignment again"), "F5", nullptr},
    {kCancelSolve, T("St&op solving"), T("Stop the computation; the last result stays"), "Ctrl+.", nullptr},
    {kPreviewMode, T("Next preview &mode"), T("Overlay, two inks, swipe, blink, lens, ..."), "O", "preview"},
    {kLessOpaque, T("&Less overlay"), T("Make the overlay more transparent"), "[", nullptr},
    {kMoreOpaque, T("M&ore overlay"), T("Make the overlay more opaque"), "]", nullptr},
    {kSwapDirection, T("Swap preview &direction"), T("Blueprint over SLAM map, or SLAM map over blueprint"), "Shift+O",
     nullptr},
    {kHighContrast, T("&High contrast"), T("For bright sunlight"), "", nullptr, true},
    {kCheatSheet, T("&Keys"), T("All keys on one page"), "F1", "help"},
    {kTour, T("&Guided tour"), T("A few steps on a sample building"), "", nullptr},
    {kAbout, T("&About CAD2SLAM"), T("Version and licence"), "", nullptr},
};

#undef T

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
    if (spec.icon) action->setIcon(QIcon(QStringLiteral(":/icons/%1.svg").arg(QLatin1String(spec.icon))));
    window->addAction(action);
    actions_[static_cast<std::size_t>(spec.id)] = action;
  }
}

}  // namespace cad2slam
