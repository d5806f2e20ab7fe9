// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/main_window/main_window.h"

#include "ui/panels/anchor_panel.h"
#include "ui/panels/preview_panel.h"
#include "ui/support/documents.h"
#include "ui/support/office_window.h"
#include "ui/tools/test_poses.h"

#include <QDockWidget>
#include <QTableView>

using namespace cad2slam;
using test::OfficeWindow;

class MainWindowTest : public QObject {
  Q_OBJECT

 private:
  std::optional<test::Sandbox> sandbox_;

 private slots:
  void init() { sandbox_.emplace(); }

  void theRobotStandsWhereItCanBeTaken() {
    OfficeWindow office;
    office.addExact(8);
    QVERIFY(office.waitUntilSolved());
    // As after a double click on an anchor's row.
    office.session().selection().set({3});
    MapView& blueprint = office.window.view(Side::kBlueprint);
    MapView& slam = office.window.view(Side::kSlam);
    blueprint.zoomBy(8.0);
    blueprint.centerOn(toQPointF(office.pairs[2].in_blueprint), false);
    slam.zoomBy(8.0);
    slam.centerOn(toQPointF(office.pairs[7].in_slam), false);
    office.window.actionTable()[ActionId::kTestPose]->setChecked(true);
    TestPoses& poses = office.window.testPoses();
    const Pose2 robot = poses.robot();
    QVERIFY((robot.translation - office.pairs[2].in_blueprint).norm() > 30.0 * blueprint.viewState().m_per_px);
    QVERIFY(office.session().rasters().grid(Side::kBlueprint)->at(robot.translation) == CellState::kFree);
    for (const Side side : {Side::kBlueprint, Side::kSlam})
      QTRY_VERIFY_WITH_TIMEOUT(office.window.view(side).isInView(toQPointF(poses.robotIn(side)->translation), 0.0),
                               test::kPatience);
    // Dragged from right over an anchor it is the robot that moves.
    poses.setRobot({office.pairs[2].in_blueprint, 0.0});
    const std::string before = test::fingerprint(office.document());
    const QPoint from = blueprint.widgetFromMetres(toQPointF(office.pairs[2].in_blueprint)).toPoint();
    QTest::mousePress(&blueprint, Qt::LeftButton, {}, from);
    for (int step = 1; step <= 5; ++step) QTest::mouseMove(&blueprint, from + QPoint(8 * step, 4 * step));
    QTest::mouseRelease(&blueprint, Qt::LeftButton, {}, from + QPoint(40, 20));
    QCOMPARE(test::fingerprint(office.document()), before);
    QVERIFY((poses.robot().translation - office.pairs[2].in_blueprint).norm() > 1e-3);
  }

  void theKeyboardGoesRoundWhatCanBeSeen() {
    OfficeWindow office;
    office.window.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&office.window));
    QWidget* const blueprint = &office.window.view(Side::kBlueprint);
    QWidget* const slam = &office.window.view(Side::kSlam);
    QWidget* const table = office.window.anchorPanel().table();
    QWidget* const preview = &office.window.preview().view();
    auto* dock = office.window.findChild<QDockWidget*>(QStringLiteral("previewDock"));
    QVERIFY(dock);
    const auto has_keyboard = [](QWidget* part) {
      return QTest::qWaitFor([part] { return QApplication::focusWidget() == part; });
    };
    const auto goes = [&](const std::vector<QWidget*>& round) {
      round.front()->window()->activateWindow();
      round.front()->setFocus();
      if (!has_keyboard(round.front())) return false;
      for (std::size_t i = 1; i <= round.size(); ++i) {
        office.window.actionTable()[ActionId::kNextPart]->trigger();
        QWidget* const expected = round[i % round.size()];
        if (!has_keyboard(expected)) return false;
      }
      return true;
    };
    QVERIFY(goes({blueprint, slam, table, preview}));
    dock->close();
    QVERIFY(goes({blueprint, slam, table}));
    dock->show();
    dock->setFloating(true);
    QVERIFY(QTest::qWaitForWindowExposed(dock));
    QVERIFY(goes({blueprint, slam, table, preview}));
    // Behind another dock in the same place.
    dock->setFloating(false);
    auto* anchors = office.window.findChild<QDockWidget*>(QStringLiteral("anchorDock"));
    office.window.tabifyDockWidget(dock, anchors);
    anchors->raise();
    QTRY_VERIFY(preview->visibleRegion().isEmpty());
    QVERIFY(goes({blueprint, slam, table}));
  }

  void aMarkerOfThePreviewIsSelectedAndCentred() {
    OfficeWindow office;
    office.addExact(8);
    QVERIFY(office.waitUntilSolved());
    MapView& preview = office.window.preview().view();
    const bool blueprint_below = office.window.preview().isBlueprintBelow();
    const auto at = [&](std::size_t i) {
      const Anchor& pair = office.pairs[i];
      return preview.widgetFromMetres(toQPointF(blueprint_below ? pair.in_blueprint : pair.in_slam)).toPoint();
    };
    QTRY_VERIFY_WITH_TIMEOUT(preview.frame() && preview.isInView(preview.metresFromWidget(at(2))), test::kPatience);
    preview.zoomBy(3.0);
    preview.centerOn(preview.metresFromWidget(at(2)), false);
    QTest::mouseClick(&preview, Qt::LeftButton, {}, at(2));
    const std::vector<AnchorId> selected{office.document().anchors()[2].id};
    QCOMPARE(office.session().selection().ids(), selected);
    // A pan takes nothing away from it, wherever it begins.
    preview.fit();
    const auto isApart = [&](std::size_t i) {
      return preview.isInView(preview.metresFromWidget(at(i)), 10.0) && QLineF(at(i), at(2)).length() > 30.0;
    };
    std::size_t other = 0;
    while (other < 8 && !isApart(other)) ++other;
    QVERIFY(other < 8);
    const QPoint start = at(other);
    QTest::mousePress(&preview, Qt::LeftButton, {}, start);
    for (const int step_px : {10, 20, 30}) QTest::mouseMove(&preview, start + QPoint(step_px, step_px));
    QTest::mouseRelease(&preview, Qt::LeftButton, {}, start + QPoint(30, 30));
    QVERIFY(QLineF(at(other), start + QPoint(30, 30)).length() < 2.0);
    QCOMPARE(office.session().selection().ids(), selected);
    preview.centerOn(preview.metresFromWidget(at(2)), false);
    preview.zoomBy(3.0);
    MapView& slam = office.window.view(Side::kSlam);
    slam.zoomBy(4.0);
    slam.centerOn(toQPointF(office.pairs[6].in_slam), false);
    QTest::mouseDClick(&preview, Qt::LeftButton, {}, at(2));
    for (const Side side : {Side::kBlueprint, Side::kSlam}) {
      const QPointF place = toQPointF(half(office.document().anchors()[2], side));
      QTRY_VERIFY(QLineF(office.window.view(side).viewState().center_m, place).length() < 1e-6);
    }
    QCOMPARE(office.document().anchors().size(), std::size_t(8));  // nothing is placed in the preview
  }
};

QTEST_MAIN(MainWindowTest)
#include "main_window_test.moc"
