// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/test_poses.h"

#include "ui/support/office_window.h"

#include <QSignalSpy>

using namespace cad2slam;
using test::OfficeWindow;

class TestPosesTest : public QObject {
  Q_OBJECT

 private slots:
  void linesAreReadAsTheyAreSeparated_data() {
    QTest::addColumn<QByteArray>("line");
    QTest::newRow("tabs, decimal commas") << QByteArray("1,5\t2,25\t0,5");
    QTest::newRow("tabs, decimal points") << QByteArray("1.5\t2.25\t0.5");
    QTest::newRow("tabs that line columns up") << QByteArray("1,5\t\t2,25\t0,5");
    QTest::newRow("commas before tabs") << QByteArray("1.5,\t2.25,\t0.5");
    QTest::newRow("semicolons, decimal commas") << QByteArray("1,5; 2,25 ;0,5");
    QTest::newRow("commas") << QByteArray("1.5,2.25, 0.5");
    QTest::newRow("spaces") << QByteArray("1.5  2.25 0.5");
  }
  void linesAreReadAsTheyAreSeparated() {
    QFETCH(QByteArray, line);
    Session session;
    TestPoses poses(session);
    const TestPoses::PoseImport import = poses.loadPoses(line + "\r\n" + line, Side::kBlueprint);
    QCOMPARE(import.shown, std::size_t(2));
    QCOMPARE(import.skipped, std::size_t(0));
    const PoseGlyph glyph = poses.glyphs(Side::kBlueprint).at(0);
    QCOMPARE(glyph.point_m, QPointF(1.5, 2.25));
    QCOMPARE(glyph.heading_rad, 0.5);
  }

  void aMissingNumberIsNotTheNextOne() {
    Session session;
    TestPoses poses(session);
    const TestPoses::PoseImport import = poses.loadPoses("1;2\n;3;4\n5;;6\n", Side::kBlueprint);
    QCOMPARE(import.shown, std::size_t(1));
    QCOMPARE(import.skipped, std::size_t(2));
  }

  void thatThereIsNoWayIsSaidAfterTheDragAndNoLongerThanItIsTrue() {
    const test::Sandbox sandbox;
    OfficeWindow office;
    office.addExact(6);
    QVERIFY(office.waitUntilSolved());
    TestPoses& poses = office.window.testPoses();
    office.window.actionTable()[ActionId::kPlanPath]->setChecked(true);
    const auto has_way = [&] { return !poses.paths(Side::kBlueprint).empty(); };
    QTRY_VERIFY_WITH_TIMEOUT(has_way(), test::kPatience);
    QPointF inside;
    for (const PoseGlyph& glyph : poses.glyphs(Side::kBlueprint))
      if (glyph.id == TestPoses::kGoal) inside = glyph.point_m;
    const QPointF outside(-1000.0, -1000.0);
    QSignalSpy failed(&poses, &TestPoses::planningFailed);
    MapView& view = office.window.view(Side::kBlueprint);
    emit view.dragStarted(TestPoses::kGoal);
    emit view.dragMoved(TestPoses::kGoal, outside);
    QTRY_VERIFY_WITH_TIMEOUT(!has_way(), test::kPatience);
    QVERIFY(failed.isEmpty());
    emit view.dragFinished(TestPoses::kGoal, outside, false);
    QTRY_COMPARE_WITH_TIMEOUT(failed.size(), 1, test::kPatience);
    QVERIFY(office.hasMessage(QStringLiteral("plan")));
    emit view.dragStarted(TestPoses::kGoal);
    emit view.dragMoved(TestPoses::kGoal, inside);
    QTRY_VERIFY_WITH_TIMEOUT(has_way(), test::kPatience);
    QVERIFY(!office.hasMessage(QStringLiteral("plan")));
    // Or when nobody asks for a way any more.
    emit view.dragFinished(TestPoses::kGoal, outside, false);
    QTRY_COMPARE_WITH_TIMEOUT(failed.size(), 2, test::kPatience);
    QVERIFY(office.hasMessage(QStringLiteral("plan")));
    office.window.actionTable()[ActionId::kPlanPath]->setChecked(false);
    QVERIFY(!office.hasMessage(QStringLiteral("plan")));
  }

  void nothingOfTheOldProjectShowsInTheNewOne() {
    const test::Sandbox sandbox;
    OfficeWindow office;
    office.addExact(6);
    QVERIFY(office.waitUntilSolved());
    TestPoses& poses = office.window.testPoses();
    QAction* plan = office.window.actionTable()[ActionId::kPlanPath];
    plan->setChecked(true);
    QTRY_VERIFY_WITH_TIMEOUT(!poses.paths(Side::kBlueprint).empty(), test::kPatience);
    Pose2 robot = poses.robot();
    robot.translation.x() += 0.3;
    poses.setRobot(robot);  // another way is on its way
    QSignalSpy changed(&poses, &TestPoses::changed);
    office.document().reset(Project{}, {});
    QVERIFY(!plan->isChecked());
    QVERIFY(!office.window.actionTable()[ActionId::kTestPose]->isChecked());
    const auto isEmpty = [&] {
      return poses.paths(Side::kBlueprint).empty() && poses.glyphs(Side::kBlueprint).empty() && !poses.isRobotVisible();
    };
    QVERIFY(isEmpty());
    // The way that was asked for before: its answer would come first.
    office.loadMaps();
    office.addExact(6);
    QVERIFY(office.waitUntilSolved());
    QVERIFY(isEmpty());
    office.window.activateWindow();
    plan->setChecked(true);
    QTRY_VERIFY_WITH_TIMEOUT(!poses.paths(Side::kBlueprint).empty(), test::kPatience);
    QVERIFY(poses.robot().translation != robot.translation);
  }
};

QTEST_MAIN(TestPosesTest)
#include "test_poses_test.moc"
