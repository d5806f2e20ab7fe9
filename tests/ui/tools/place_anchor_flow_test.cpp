// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/place_anchor_flow.h"

#include "ui/document/project_document.h"
#include "ui/support/documents.h"

#include <QSignalSpy>
#include <QTest>

using namespace cad2slam;

class PlaceAnchorFlowTest : public QObject {
  Q_OBJECT

 private:
  ProjectDocument document_;
  PlaceAnchorFlow flow_{document_};

 private slots:
  void init() { document_.reset(test::smallProject(), {}); }

  void scenario2_eitherSideFirst_data() {
    QTest::addColumn<bool>("blueprint_first");
    QTest::newRow("blueprint first") << true;
    QTest::newRow("SLAM map first") << false;
  }
  void scenario2_eitherSideFirst() {
    QFETCH(bool, blueprint_first);
    QSignalSpy completed(&flow_, &PlaceAnchorFlow::completed);
    if (blueprint_first) {
      flow_.click(Side::kBlueprint, {1, 2}, false);
      flow_.click(Side::kSlam, {3, 4}, false);
    } else {
      flow_.click(Side::kSlam, {3, 4}, false);
      flow_.click(Side::kBlueprint, {1, 2}, false);
    }
    QCOMPARE(completed.size(), 1);
    QCOMPARE(document_.anchors().size(), std::size_t(1));
    QCOMPARE(document_.anchors()[0], (Anchor{1, {1, 2}, {3, 4}, true, {}, {}}));
    QCOMPARE(document_.undoStack().count(), 1);
    QVERIFY(!flow_.half());
  }

  void scenario4_aSecondClickInTheSameViewMovesTheHalf() {
    flow_.click(Side::kSlam, {3, 4}, false);
    flow_.click(Side::kSlam, {5, 6}, true);
    QVERIFY(flow_.half().has_value());
    QCOMPARE(flow_.half()->point_m, QPointF(5, 6));
    QVERIFY(flow_.half()->snapped);
    QVERIFY(document_.anchors().empty());
    QCOMPARE(document_.undoStack().count(), 0);
  }

  void scenario4_cancelTenTimes() {
    flow_.click(Side::kSlam, {3, 4}, false);
    QVERIFY(flow_.cancel());
    for (int i = 0; i < 10; ++i) QVERIFY(!flow_.cancel());
    QVERIFY(!flow_.half());
    QCOMPARE(document_.undoStack().count(), 0);
  }

  void scenario6_acceptNeedsAPrediction() {
    QVERIFY(!flow_.acceptPrediction());
    flow_.click(Side::kBlueprint, {1, 2}, false);
    QVERIFY(!flow_.acceptPrediction());
    flow_.setPrediction(QPointF(7, 8));
    QVERIFY(flow_.acceptPrediction());
    QCOMPARE(document_.anchors()[0].in_slam, Eigen::Vector2d(7, 8));
    QVERIFY(!flow_.prediction());
  }

  void movingTheHalfForgetsThePrediction() {
    flow_.click(Side::kBlueprint, {1, 2}, false);
    flow_.setPrediction(QPointF(7, 8));
    flow_.click(Side::kBlueprint, {1.5, 2}, false);
    QVERIFY(!flow_.acceptPrediction());
  }

  void snappedIsKeptFromEitherHalf() {
    flow_.click(Side::kBlueprint, {1, 2}, true);
    flow_.click(Side::kSlam, {1, 2}, false);
    flow_.click(Side::kBlueprint, {4, 2}, false);
    flow_.click(Side::kSlam, {4, 2}, true);
    flow_.click(Side::kBlueprint, {4, 9}, false);
    flow_.click(Side::kSlam, {4, 9}, false);
    QVERIFY(document_.isSnapped(1));
    QVERIFY(document_.isSnapped(2));
    QVERIFY(!document_.isSnapped(3));
  }

  void lockedOrWithoutMapNothingHappens() {
    document_.setLocked(true);
    flow_.click(Side::kBlueprint, {1, 2}, false);
    QVERIFY(!flow_.half());
    document_.reset(Project{}, {});
    flow_.click(Side::kBlueprint, {1, 2}, false);
    QVERIFY(!flow_.half());
  }

  void eachMapHasItsOwnHalf() {
    Project project = test::smallProject();
    project.slam_maps.push_back(project.slam_maps[0]);
    project.slam_maps[1].name = "robot 2";
    document_.reset(project, {});
    flow_.click(Side::kBlueprint, {1, 2}, false);
    document_.setCurrentMap("robot 2");
    QVERIFY(!flow_.half());
    flow_.click(Side::kSlam, {3, 4}, false);
    QVERIFY(document_.anchors().empty());
    document_.setCurrentMap("robot 1");
    QCOMPARE(flow_.half()->side, Side::kBlueprint);
  }
};

QTEST_GUILESS_MAIN(PlaceAnchorFlowTest)
#include "place_anchor_flow_test.moc"
