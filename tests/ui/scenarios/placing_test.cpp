// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/mesh/mesh_builder.h"
#include "cad2slam/projection/make_projector.h"
#include "cad2slam/solver/mesh_solver.h"
#include "ui/panels/anchor_panel.h"
#include "ui/panels/status_strip.h"
#include "ui/support/documents.h"
#include "ui/support/office_window.h"

#include <QMouseEvent>
#include <QTableView>

#include <algorithm>

using namespace cad2slam;
using test::OfficeWindow;

class PlacingTest : public QObject {
  Q_OBJECT

 private:
  std::optional<test::Sandbox> sandbox_;

 private slots:
  void init() { sandbox_.emplace(); }

  void scenario1_fourAnchorsByFollowingTheHints() {
    OfficeWindow office(false);
    QVERIFY(office.window.status().hint().contains(QStringLiteral("blueprint")));
    office.window.files().setImage(Side::kBlueprint, OfficeWindow::sample("blueprint.yaml"));
    QVERIFY(office.window.status().hint().contains(QStringLiteral("SLAM map")));
    office.loadMaps();
    QTRY_VERIFY_WITH_TIMEOUT(office.window.status().hint().contains(QStringLiteral("Click a corner")), test::kPatience);
    QStringList hints;
    for (std::size_t i = 0; i < 4; ++i) {
      office.click(Side::kBlueprint, toQPointF(office.pairs[i].in_blueprint));
      hints += office.window.status().hint();
      office.click(Side::kSlam, toQPointF(office.pairs[i].in_slam));
      QVERIFY(office.waitUntilSolved());
      hints += office.window.status().hint();
    }
    QCOMPARE(office.document().anchors().size(), std::size_t(4));
    QVERIFY(hints.removeDuplicates() <= 3);  // nearly each state says something else
    QVERIFY(office.session().summary().rms_residual_m.value() < 1.0);
    QVERIFY(office.session().summary().median_leave_one_out_m.has_value());
    QVERIFY(office.window.status().chipText().contains(QStringLiteral("up to date")));
  }

  void scenario2_eitherViewFirst() {
    OfficeWindow office;
    office.click(Side::kSlam, toQPointF(office.pairs[0].in_slam));
    QVERIFY(office.document().pending().has_value());
    office.click(Side::kBlueprint, toQPointF(office.pairs[0].in_blueprint));
    office.place(1);
    QCOMPARE(office.document().anchors().size(), std::size_t(2));
    for (std::size_t i = 0; i < 2; ++i) {
      const Anchor& placed = office.document().anchors()[i];
      QVERIFY((placed.in_blueprint - office.pairs[i].in_blueprint).norm() <= office.clickError(Side::kBlueprint));
      QVERIFY((placed.in_slam - office.pairs[i].in_slam).norm() <= office.clickError(Side::kSlam));
    }
  }

  void scenario3_aHalfStaysOnItsFeature() {
    OfficeWindow office;
    const int steps = office.document().undoStack().count();
    office.click(Side::kBlueprint, toQPointF(office.pairs[0].in_blueprint));
    const PendingAnchor before = office.document().pending().value();
    for (const Side side : {Side::kBlueprint, Side::kSlam}) {
      office.window.view(side).zoomBy(7.0);
      office.window.view(side).centerOn({3.0, 4.0}, false);
    }
    const PendingAnchor after = office.document().pending().value();
    QCOMPARE(after.x_m, before.x_m);
    QCOMPARE(after.y_m, before.y_m);
    office.key(Side::kBlueprint, Qt::Key_Escape);
    QVERIFY(!office.document().pending());
    QCOMPARE(office.document().undoStack().count(), steps);
  }

  void scenario4_twoClicksInOneViewAndTenTimesEscape() {
    OfficeWindow office;
    office.click(Side::kSlam, toQPointF(office.pairs[0].in_slam));
    office.click(Side::kSlam, toQPointF(office.pairs[1].in_slam));
    QVERIFY(office.document().anchors().empty());
    QVERIFY(std::abs(office.document().pending()->x_m - office.pairs[1].in_slam.x()) <= office.clickError(Side::kSlam));
    for (int i = 0; i < 10; ++i) office.key(Side::kSlam, Qt::Key_Escape);
    QVERIFY(office.window.isVisible());
    QVERIFY(!office.document().pending());
    office.addExact(2);
    for (int i = 0; i < 10; ++i) QTest::keyClick(&office.window, Qt::Key_Escape);
    QVERIFY(office.window.isVisible());
    QCOMPARE(office.document().anchors().size(), std::size_t(2));
  }

  void scenario5_dragsPanAndJitterStillClicks() {
    OfficeWindow office;
    office.addExact(1);
    const std::string before = test::fingerprint(office.document());
    MapView& view = office.window.view(Side::kBlueprint);
    const QPoint marker = view.widgetFromMetres(toQPointF(office.pairs[0].in_blueprint)).toPoint();
    const QPoint near = marker + QPoint(25, 0);  // outside the radius that takes hold of the marker
    const QPointF center = view.viewState().center_m;
    QTest::mousePress(&view, Qt::LeftButton, {}, near);
    for (int i = 1; i <= 10; ++i) QTest::mouseMove(&view, near + QPoint(6 * i, 3 * i));
    QTest::mouseRelease(&view, Qt::LeftButton, {}, near + QPoint(60, 30));
    QCOMPARE(test::fingerprint(office.document()), before);
    QVERIFY(!office.document().pending());
    QVERIFY(view.viewState().center_m != center);
    QTest::mousePress(&view, Qt::LeftButton, {}, near);
    QTest::mouseMove(&view, near + QPoint(2, 1));
    QTest::mouseRelease(&view, Qt::LeftButton, {}, near + QPoint(2, 2));
    QVERIFY(office.document().pending().has_value());
  }

  void scenario6_theCounterpartIsPredictedAndEnterTakesIt() {
    OfficeWindow office;
    office.addExact(6);
    QVERIFY(office.waitUntilSolved());
    office.click(Side::kBlueprint, toQPointF(office.pairs[8].in_blueprint));
    QTRY_VERIFY_WITH_TIMEOUT(office.session().flow().prediction().has_value(), test::kPatience);
    const Eigen::Vector2d predicted = toEigen(*office.session().flow().prediction());
    QVERIFY((predicted - office.pairs[8].in_slam).norm() < 2.0);
    office.key(Side::kSlam, Qt::Key_Return);
    QCOMPARE(office.document().anchors().size(), std::size_t(7));
    QCOMPARE(office.document().anchors().back().in_slam, predicted);
    // A wrong prediction is corrected by clicking elsewhere.
    office.click(Side::kBlueprint, toQPointF(office.pairs[9].in_blueprint));
    office.click(Side::kSlam, toQPointF(office.pairs[9].in_slam));
    QVERIFY((office.document().anchors().back().in_slam - office.pairs[9].in_slam).norm() <=
            office.clickError(Side::kSlam));
  }

  void scenario7_afterADragTheResultIsThatOfAFreshSolve() {
    OfficeWindow office;
    office.addExact(8);
    QVERIFY(office.waitUntilSolved());
    MapView& view = office.window.view(Side::kSlam);
    const QPoint from = view.widgetFromMetres(toQPointF(office.pairs[3].in_slam)).toPoint();
    std::uint64_t last = 0;
    bool in_order = true;
    connect(&office.session().alignment(), &Alignment::resultChanged, this, [&] {
      const SolveResultPtr& result = office.session().alignment().result();
      in_order = in_order && result->revision >= last;
      last = result->revision;
    });
    QTest::mousePress(&view, Qt::LeftButton, {}, from);
    for (int i = 1; i <= 30; ++i) {
      QTest::mouseMove(&view, from + QPoint(i, i / 2));
      QTest::qWait(10);
    }
    QTest::mouseRelease(&view, Qt::LeftButton, {}, from + QPoint(30, 15));
    QVERIFY(office.waitUntilSolved());
    QVERIFY(in_order);
    QCOMPARE(office.document().undoStack().undoText().contains(QStringLiteral("move anchor")), true);

    const SolveResultPtr live = office.session().alignment().result();
    const auto mesh = std::make_shared<const Mesh>(
        buildMesh(*office.session().rasters().grid(Side::kBlueprint), office.document().project().cell_size_m).value());
    MeshSolver solver(mesh);
    const Solution fresh = solver.solve(office.document().anchors(), office.document().project().settings).value();
    QCOMPARE(live->solution.node_slam.size(), fresh.node_slam.size());
    double largest = 0.0;
    for (std::size_t i = 0; i < fresh.node_slam.size(); ++i)
      largest = std::max(largest, (fresh.node_slam[i].translation - live->solution.node_slam[i].translation).norm());
    QVERIFY2(largest < 1e-4, qPrintable(QString::number(largest)));
  }

  void scenario7_escapeWhileDraggingRestores() {
    OfficeWindow office;
    office.addExact(4);
    const std::string before = test::fingerprint(office.document());
    const int steps = office.document().undoStack().count();
    MapView& view = office.window.view(Side::kBlueprint);
    const QPoint from = view.widgetFromMetres(toQPointF(office.pairs[2].in_blueprint)).toPoint();
    QTest::mousePress(&view, Qt::LeftButton, {}, from);
    for (int i = 1; i <= 20; ++i) QTest::mouseMove(&view, from + QPoint(2 * i, 0));
    QVERIFY(test::fingerprint(office.document()) != before);
    QTest::keyClick(&view, Qt::Key_Escape);
    QCOMPARE(test::fingerprint(office.document()), before);
    QTest::mouseRelease(&view, Qt::LeftButton, {}, from + QPoint(40, 0));
    QCOMPARE(office.document().undoStack().count(), steps);
  }

  void scenario8_nudgesAreOneStepAndUndoGivesTheSameProjector() {
    OfficeWindow office;
    office.addExact(6);
    QVERIFY(office.waitUntilSolved());
    const std::string before = test::fingerprint(office.document());
    const auto project = [&] {
      return office.session()
          .alignment()
          .result()
          ->projector.slamFromBlueprint({office.pairs[10].in_blueprint, 0.3}, OutsidePolicy::kRigid)
          .pose;
    };
    const Pose2 pose_before = project();
    const int steps = office.document().undoStack().count();
    office.session().selection().set({2});
    for (int i = 0; i < 5; ++i) office.key(Side::kSlam, Qt::Key_Right);
    office.key(Side::kSlam, Qt::Key_Up, Qt::ShiftModifier);
    QCOMPARE(office.document().undoStack().count(), steps + 1);
    const Eigen::Vector2d moved = office.document().anchor(2)->in_slam - office.pairs[1].in_slam;
    QVERIFY((moved - Eigen::Vector2d(5 * 0.05, 10 * 0.05)).norm() < 1e-9);
    QVERIFY(office.waitUntilSolved());
    office.document().undoStack().undo();
    QCOMPARE(test::fingerprint(office.document()), before);
    QVERIFY(office.waitUntilSolved());
    QVERIFY((project().translation - pose_before.translation).norm() < 1e-5);
  }

  void scenario9_deleteAllAndComeBack() {
    OfficeWindow office;
    office.addExact(5);
    QVERIFY(office.waitUntilSolved());
    office.window.actionTable()[ActionId::kSelectAll]->trigger();
    QCOMPARE(office.session().selection().ids().size(), std::size_t(5));
    const int steps = office.document().undoStack().count();
    office.window.actionTable()[ActionId::kDelete]->trigger();
    QCOMPARE(office.document().undoStack().count(), steps + 1);
    QVERIFY(office.document().anchors().empty());
    QVERIFY(!office.session().alignment().result());
    QVERIFY(office.session().alignment().status() == AlignmentStatus::kNoAnchors);
    QVERIFY(office.hasMessage(QStringLiteral("toast")));
    QVERIFY(office.pressCure(QStringLiteral("toast"), QStringLiteral("Undo")));
    QCOMPARE(office.document().anchors().size(), std::size_t(5));
    QCOMPARE(office.session().selection().ids().size(), std::size_t(5));
    QVERIFY(office.waitUntilSolved());
    for (const std::size_t left : {2, 1}) {
      std::vector<AnchorId> ids;
      while (office.document().anchors().size() - ids.size() > left)
        ids.push_back(office.document().anchors()[ids.size()].id);
      edit::deleteAnchors(office.document(), ids);
      QVERIFY(office.waitUntilSolved());
      QCOMPARE(office.session().alignment().result()->solution.anchors_used, left);
    }
  }
};

QTEST_MAIN(PlacingTest)
#include "placing_test.moc"
