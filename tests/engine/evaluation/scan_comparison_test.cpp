// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/evaluation/scan_comparison.h"

#include <opencv2/core.hpp>

#include <QtTest>

#include <cmath>

#include "cad2slam/evaluation/alignment_method.h"
#include "evaluation_site.h"

using namespace cad2slam;

namespace {

/// A projector of a rigid motion over a generated building, and the "SLAM map" that motion makes of its blueprint.
struct Scene {
  test::EvaluationSite made;
  Projector projector;
  OccupancyGrid slam;
  Pose2 slam_from_blueprint;
};

Scene makeScene(double offset_m) {
  test::EvaluationSite made = test::makeEvaluationSite(test::rigidWarp(), 12, 0.0);
  // The same pixels in a moved and turned frame are exactly what a rigid SLAM map would be.
  const Pose2 at_origin = made.site.slamFromBlueprint({{0.0, 0.0}, 0.0});
  const MapFrame& frame = made.site.building.blueprint.frame();
  Pose2 corner = at_origin * frame.metricFromCorner();
  corner.translation += Eigen::Vector2d(offset_m, 0.0);
  const OccupancyGrid slam(*MapFrame::create(frame.resolution(), frame.width(), frame.height(), corner),
                           made.site.building.blueprint.states());
  Projector projector = MethodFitter(made.mesh).fitProjector(AlignmentMethod::kRigid, made.site.anchors).value();
  return {std::move(made), std::move(projector), slam, at_origin};
}

}  // namespace

class ScanComparisonTest : public QObject {
  Q_OBJECT
 private slots:
  void perfectProjectionAgreesEverywhere() {
    const Scene scene = makeScene(0.0);
    const OccupancyGrid& blueprint = scene.made.site.building.blueprint;
    const Result<std::vector<StartGoal>> ends = randomStartGoals(blueprint, 2, {}, 3);
    QVERIFY(ends);
    ScanOptions options;
    options.planner.step_m = 0.5;
    const Result<ScanComparison> result = compareScans(scene.projector, blueprint, scene.slam, *ends, options);
    QVERIFY(result);
    QCOMPARE(result->paths.size(), std::size_t{2});
    QCOMPARE(result->agreement.size(), std::size_t{4});
    QVERIFY(result->scans > 20);
    for (const ScanAgreement& agreement : result->agreement) {
      QVERIFY(agreement.mean_m < 1e-4);
      QVERIFY(agreement.outliers < 2.0);  // rounding can move a beam past a corner
    }
    for (const ComparedPath& path : result->paths) {
      QCOMPARE(path.in_slam.size(), path.in_blueprint.poses.size());
      for (std::size_t i = 0; i < path.in_slam.size(); ++i) {
        const Pose2 expected = scene.slam_from_blueprint * path.in_blueprint.poses[i];
        QVERIFY((path.in_slam[i].translation - expected.translation).norm() < 1e-4);
      }
    }
  }

  void wallsThatAreMovedAreFound() {
    const Scene scene = makeScene(0.2);
    const OccupancyGrid& blueprint = scene.made.site.building.blueprint;
    const Result<std::vector<StartGoal>> ends = randomStartGoals(blueprint, 1, {}, 5);
    ScanOptions options;
    options.planner.step_m = 0.5;
    const Result<ScanComparison> result = compareScans(scene.projector, blueprint, scene.slam, *ends, options);
    QVERIFY(result);
    const ScanAgreement& strict = result->agreement.front();
    const ScanAgreement& loose = result->agreement.back();
    QVERIFY(strict.outliers > 200.0);
    QVERIFY(loose.outliers < strict.outliers);
    QVERIFY(loose.mean_m > 0.01 && loose.mean_m < 0.25);
    for (std::size_t i = 1; i < result->agreement.size(); ++i) {
      QVERIFY(result->agreement[i].outliers <= result->agreement[i - 1].outliers);
      QVERIFY(result->agreement[i].mean_m <= result->agreement[i].threshold_m);
      QVERIFY(result->agreement[i].sum_of_squares_m2 >= result->agreement[i - 1].sum_of_squares_m2);
    }
  }

  void threadsDoNotChangeTheResult() {
    const Scene scene = makeScene(0.1);
    const OccupancyGrid& blueprint = scene.made.site.building.blueprint;
    const Result<std::vector<StartGoal>> ends = randomStartGoals(blueprint, 1, {}, 7);
    ScanOptions one;
    one.threads = 1;
    ScanOptions three;
    three.threads = 3;
    const auto a = compareScans(scene.projector, blueprint, scene.slam, *ends, one);
    const auto b = compareScans(scene.projector, blueprint, scene.slam, *ends, three);
    QVERIFY(a && b);
    QCOMPARE(a->agreement[2].mean_m, b->agreement[2].mean_m);
    QCOMPARE(a->agreement[2].outliers, b->agreement[2].outliers);
  }

  void brokenPathsAreNamedByNumber() {
    const Scene scene = makeScene(0.0);
    const OccupancyGrid& blueprint = scene.made.site.building.blueprint;
    std::vector<StartGoal> ends = *randomStartGoals(blueprint, 1, {}, 9);
    ends.push_back({{1e5, 0.0}, ends[0].goal});
    const auto result = compareScans(scene.projector, blueprint, scene.slam, ends, {});
    QVERIFY(!result);
    QCOMPARE(result.error().where, std::string("path 2"));
    QVERIFY(QString::fromStdString(result.error().message).contains("outside"));
    ScanOptions no_beams;
    no_beams.lidar.beams = 0;
    QVERIFY(!compareScans(scene.projector, blueprint, scene.slam, {}, no_beams));
  }

  void randomEndsAreFreeSeededAndApart() {
    const Scene scene = makeScene(0.0);
    const OccupancyGrid& blueprint = scene.made.site.building.blueprint;
    const auto a = randomStartGoals(blueprint, 6, {}, 11);
    const auto b = randomStartGoals(blueprint, 6, {}, 11);
    QVERIFY(a && b);
    QCOMPARE(a->size(), std::size_t{6});
    for (std::size_t i = 0; i < a->size(); ++i) {
      QCOMPARE((*a)[i].start, (*b)[i].start);
      QCOMPARE(blueprint.at((*a)[i].start), CellState::kFree);
      QCOMPARE(blueprint.at((*a)[i].goal), CellState::kFree);
    }
    const cv::Mat solid(20, 20, CV_8UC1, cv::Scalar(static_cast<int>(CellState::kOccupied)));
    QVERIFY(!randomStartGoals(OccupancyGrid(*MapFrame::create(0.1, 20, 20, {}), solid), 3, {}, 1));
  }
};

QTEST_APPLESS_MAIN(ScanComparisonTest)
#include "scan_comparison_test.moc"
