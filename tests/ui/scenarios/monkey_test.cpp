// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/document/project_commands.h"
#include "ui/panels/anchor_panel.h"
#include "ui/panels/preview_panel.h"
#include "ui/support/documents.h"
#include "ui/support/office_window.h"

#include <QTableView>

#include <functional>
#include <random>
#include <set>
#include <vector>

using namespace cad2slam;
using test::OfficeWindow;
using enum ActionId;

/// Does whatever comes to its mind, always the same with the same seed: CAD2SLAM_MONKEY_SEED and
/// CAD2SLAM_MONKEY_ACTIONS choose another run.
class MonkeyTest : public QObject {
  Q_OBJECT

 private:
  std::mt19937 random_;

  int below(int limit) { return int(random_() % std::uint32_t(limit)); }
  double between(double low, double high) { return low + (high - low) * double(random_()) / double(random_.max()); }
  Side anySide() { return below(2) == 0 ? Side::kBlueprint : Side::kSlam; }

  QPoint anyPlace(MapView& view) { return {below(view.width()), below(view.height())}; }

  AnchorId anyAnchor(OfficeWindow& office) {
    const AnchorList& anchors = office.document().anchors();
    return anchors.empty() ? 0 : anchors[std::size_t(below(int(anchors.size())))].id;
  }

  void act(OfficeWindow& office) {
    static constexpr ActionId kHarmless[] = {
        kUndo,        kUndo,          kRedo,         kDelete,       kToggleEnabled,
        kSwap,        kSelectAll,     kDisableWorst, kLock,         kLock,
        kSnap,        kFlip,          kFit,          kActualSize,   kZoomIn,
        kZoomOut,     kRotateLeft,    kRotateRight,  kRotateReset,  kCenterOnSelection,
        kNextWorst,   kPreviousWorst, kLink,         kOtherFollows, kFollowOther,
        kLoupe,       kMarkers,       kTexts,        kMesh,         kResiduals,
        kExaggerate,  kTestPose,      kPlanPath,     kNextPart,     kSolveAgain,
        kCancelSolve, kPreviewMode,   kLessOpaque,   kMoreOpaque,   kSwapDirection};
    static constexpr Qt::Key kKeys[] = {Qt::Key_Escape, Qt::Key_Return, Qt::Key_Left, Qt::Key_Up, Qt::Key_Tab,
                                        Qt::Key_Delete, Qt::Key_Space,  Qt::Key_Z,    Qt::Key_B,  Qt::Key_X};
    const Side side = anySide();
    MapView& view = office.window.view(side);
    ProjectDocument& document = office.document();
    switch (below(14)) {
      case 0:
      case 1:
      case 2:
        QTest::mouseClick(&view, Qt::LeftButton, {}, anyPlace(view));
        break;
      case 3: {
        const Anchor* anchor = document.anchor(anyAnchor(office));
        const QPoint from = anchor ? view.widgetFromMetres(toQPointF(half(*anchor, side))).toPoint() : anyPlace(view);
        if (!view.rect().contains(from)) break;
        QTest::mousePress(&view, Qt::LeftButton, {}, from);
        for (int i = 0; i < 3; ++i) QTest::mouseMove(&view, anyPlace(view));
        if (below(4) == 0) QTest::keyClick(&view, Qt::Key_Escape);
        QTest::mouseRelease(&view, Qt::LeftButton, {}, anyPlace(view));
        break;
      }
      case 4:
        QTest::keyClick(&view, kKeys[below(int(std::size(kKeys)))]);
        break;
      case 5:
      case 6:
      case 7:
        office.window.actionTable()[kHarmless[below(int(std::size(kHarmless)))]]->trigger();
        break;
      case 8:
        office.session().selection().set({anyAnchor(office)});
        break;
      case 9:
        office.session().selection().toggle(anyAnchor(office));
        break;
      case 10:
        if (!document.isLocked()) edit::rename(document, anyAnchor(office), std::to_string(below(100)));
        break;
      case 11:
        if (!document.isLocked())
          edit::setCoordinates(document, anyAnchor(office), {between(-10, 38), between(-5, 23)},
                               {between(-28, 23), between(-14, 20)});
        break;
      case 12:
        if (below(20) == 0 && !document.isLocked()) edit::rescaleBlueprint(document, between(0.8, 1.25));
        break;
      default: {
        QTableView& table = *office.window.anchorPanel().table();
        table.sortByColumn(below(AnchorTableModel::kColumnCount),
                           below(2) == 0 ? Qt::AscendingOrder : Qt::DescendingOrder);
        QTest::mouseClick(table.viewport(), Qt::LeftButton, {}, {below(300), below(120)});
        break;
      }
    }
  }

  static void checkInvariants(OfficeWindow& office) {
    std::set<AnchorId> ids;
    for (const Anchor& anchor : office.document().anchors()) {
      QVERIFY(ids.insert(anchor.id).second);
      QVERIFY(anchor.id < office.document().nextId());
      QVERIFY(anchor.in_blueprint.allFinite() && anchor.in_slam.allFinite());
    }
    QCOMPARE(office.window.anchorPanel().model().rowCount(), int(ids.size()));
    for (const AnchorId id : office.session().selection().ids()) QVERIFY(ids.contains(id));
    QVERIFY(office.window.isVisible());
  }

 private slots:
  void nothingBreaksAndUndoLeadsBackToTheStart() {
    test::Sandbox sandbox;
    bool given = false;
    const int actions = qEnvironmentVariableIntValue("CAD2SLAM_MONKEY_ACTIONS", &given);
    random_.seed(std::uint32_t(qEnvironmentVariableIntValue("CAD2SLAM_MONKEY_SEED")));
    OfficeWindow office;
    office.document().undoStack().clear();
    const std::string start = test::fingerprint(office.document());
    const int wanted = given ? actions : 20'000;
    for (int i = 0; i < wanted; ++i) {
      act(office);
      if (i % 16 == 0) QCoreApplication::processEvents();
      if (i % 200 == 0) checkInvariants(office);
      if (QTest::currentTestFailed()) return;
      // Thousands of anchors test the solver rather than the window.
      if (office.document().anchors().size() > 60 && !office.document().isLocked())
        edit::deleteAnchors(office.document(), {anyAnchor(office), anyAnchor(office), anyAnchor(office)});
    }
    checkInvariants(office);
    office.document().setLocked(false);
    while (office.document().undoStack().canUndo()) office.document().undoStack().undo();
    checkInvariants(office);
    QVERIFY(test::fingerprint(office.document()) == start);
  }
};

QTEST_MAIN(MonkeyTest)
#include "monkey_test.moc"
