// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/io/projector_file.h"
#include "cad2slam/mesh/mesh_builder.h"
#include "cad2slam/projection/make_projector.h"
#include "cad2slam/solver/mesh_solver.h"
#include "ui/document/project_commands.h"
#include "ui/main_window/exports.h"
#include "ui/panels/anchor_panel.h"
#include "ui/panels/preview_panel.h"
#include "ui/panels/status_strip.h"
#include "ui/support/documents.h"
#include "ui/support/office_window.h"

#include <QMouseEvent>
#include <QTableView>
#include <QTemporaryDir>

#include <algorithm>
#include <map>

using namespace cad2slam;
using test::OfficeWindow;

namespace {

/// The projector file of what the window shows, to the last bit but for the time it was made.
QByteArray exportedProjector(OfficeWindow& office) {
  const QTemporaryDir folder;
  const QString path = folder.filePath(QStringLiteral("projector.c2s"));
  if (!office.window.exports().exportProjector(path)) return {};
  Result<ProjectorData> data = readProjectorFile(toPath(path));
  if (!data) return {};
  data->info.created.clear();
  if (!writeProjectorFile(toPath(path), *data)) return {};
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

}  // namespace

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

  void scenario27_anAnchorIsPlacedWithoutAMouse() {
    OfficeWindow office;
    const auto middle = [&office](Side side) {
      const MapView& view = office.window.view(side);
      return toEigen(view.metresFromWidget(QRectF(view.rect()).center()));
    };
    std::map<Side, Eigen::Vector2d> clicked;
    for (const Side side : {Side::kBlueprint, Side::kSlam}) {
      const Eigen::Vector2d before = middle(side);
      office.key(side, Qt::Key_Right);
      office.key(side, Qt::Key_Up);
      const Eigen::Vector2d coarse = middle(side) - before;
      office.key(side, Qt::Key_Right, Qt::ControlModifier);
      const Eigen::Vector2d fine = middle(side) - before - coarse;
      QVERIFY(coarse.x() > 0.0 && coarse.y() > 0.0 && fine.x() > 0.0);
      QVERIFY(std::abs(fine.x() / coarse.x() - 0.1) < 1e-6);
      clicked[side] = middle(side);
      QTest::keyClick(&office.window.view(side), Qt::Key_Insert);
    }
    QCOMPARE(office.document().anchors().size(), std::size_t(1));
    for (const Side side : {Side::kBlueprint, Side::kSlam})
      QVERIFY((half(office.document().anchors()[0], side) - clicked[side]).norm() < 1e-9);
    // Arrow keys now move the anchor that is there, not the map.
    office.key(Side::kSlam, Qt::Key_Left);
    QVERIFY((middle(Side::kSlam) - clicked[Side::kSlam]).norm() < 1e-9);
    QVERIFY(office.document().anchors()[0].in_slam.x() < clicked[Side::kSlam].x());
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
    int while_dragging = 0;
    bool in_order = true;
    connect(&office.session().alignment(), &Alignment::resultChanged, this, [&] {
      const SolveResultPtr& result = office.session().alignment().result();
      in_order = in_order && result->revision >= last;
      last = result->revision;
      while_dragging += result->quality == Quality::kPreview ? 1 : 0;
    });
    QTest::mousePress(&view, Qt::LeftButton, {}, from);
    for (int i = 1; i <= 30 || (while_dragging < 3 && i < 600); ++i) {
      QTest::mouseMove(&view, from + QPoint(i % 30, i / 2 % 15));
      QTest::qWait(10);
    }
    QVERIFY(while_dragging >= 3);  // the preview follows the drag
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

  void scenario8_undoAllAndRedoAllAreBitIdentical() {
    OfficeWindow office;
    office.addExact(10);
    office.document().undoStack().clear();
    QVERIFY(office.waitUntilSolved());
    const std::string start = test::fingerprint(office.document());
    const QByteArray exported_at_start = exportedProjector(office);

    const Actions& actions = office.window.actionTable();
    std::vector<std::string> states{start};
    const auto step = [&] {
      QVERIFY(test::fingerprint(office.document()) != states.back());
      QCOMPARE(office.document().undoStack().index(), int(states.size()));  // one gesture, one step
      states.push_back(test::fingerprint(office.document()));
    };
    MapView& view = office.window.view(Side::kSlam);
    const QPoint from = view.widgetFromMetres(toQPointF(office.pairs[0].in_slam)).toPoint();
    QTest::mousePress(&view, Qt::LeftButton, {}, from);
    for (int i = 1; i <= 8; ++i) QTest::mouseMove(&view, from + QPoint(3 * i, i));
    QTest::mouseRelease(&view, Qt::LeftButton, {}, from + QPoint(24, 8));
    step();
    office.session().selection().set({2});
    for (int i = 0; i < 3; ++i) office.key(Side::kBlueprint, Qt::Key_Left);
    step();
    edit::rename(office.document(), 3, "pillar");
    step();
    office.session().selection().set({4});
    actions[ActionId::kToggleEnabled]->trigger();
    step();
    office.session().selection().set({5, 6, 7, 8, 9});
    actions[ActionId::kDelete]->trigger();
    QCOMPARE(office.document().anchors().size(), std::size_t(5));
    step();
    edit::rescaleBlueprint(office.document(), 1.1);
    step();
    actions[ActionId::kFlip]->trigger();
    step();
    QVERIFY(office.waitUntilReady());
    QVERIFY(office.waitUntilSolved());
    const QByteArray exported_at_end = exportedProjector(office);

    for (std::size_t i = states.size() - 1; i > 0; --i) {
      actions[ActionId::kUndo]->trigger();
      QVERIFY(test::fingerprint(office.document()) == states[i - 1]);
    }
    QVERIFY(office.waitUntilReady());
    QVERIFY(office.waitUntilSolved());
    QVERIFY(exportedProjector(office) == exported_at_start);
    for (std::size_t i = 1; i < states.size(); ++i) {
      actions[ActionId::kRedo]->trigger();
      QVERIFY(test::fingerprint(office.document()) == states[i]);
    }
    QVERIFY(office.waitUntilReady());
    QVERIFY(office.waitUntilSolved());
    QVERIFY(exportedProjector(office) == exported_at_end);
    QVERIFY(exported_at_end != exported_at_start);
  }

  void aMessageDoesNotMoveTheMapUnderTheCursor() {
    OfficeWindow office;
    office.addExact(3);
    QVERIFY(office.waitUntilSolved());
    office.window.messages().showGroup(QString(), {});
    QCursor::setPos(office.window.view(Side::kBlueprint).mapToGlobal(QPoint(200, 200)));  // about to click
    QCoreApplication::processEvents();
    const auto seen = [&](Side side) {
      MapView& v = office.window.view(side);
      return v.mapTo(&office.window, v.widgetFromMetres({5.0, 5.0}).toPoint());
    };
    const QPoint left = seen(Side::kBlueprint);
    const QPoint right = seen(Side::kSlam);
    const int height = office.window.view(Side::kBlueprint).height();
    office.window.messages().show({QStringLiteral("a"), Severity::kError, QStringLiteral("one"), {}, 0});
    office.window.messages().show({QStringLiteral("b"), Severity::kError, QStringLiteral("two"), {}, 0});
    QTRY_VERIFY(office.window.view(Side::kBlueprint).height() < height);
    QVERIFY((seen(Side::kBlueprint) - left).manhattanLength() <= 2);
    QVERIFY((seen(Side::kSlam) - right).manhattanLength() <= 2);
    office.window.messages().showGroup(QString(), {});
    QTRY_COMPARE(office.window.view(Side::kBlueprint).height(), height);
    QVERIFY((seen(Side::kBlueprint) - left).manhattanLength() <= 2);
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
    QVERIFY(office.window.preview().view().picture().image.isNull());
    QVERIFY(exportChecks(office.session()).front().verdict == ExportCheck::Verdict::kRefused);
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
