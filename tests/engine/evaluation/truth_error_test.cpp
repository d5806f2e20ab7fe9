// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/evaluation/truth_error.h"

#include <QtTest>

#include <cmath>

#include "evaluation_site.h"

using namespace cad2slam;

class TruthErrorTest : public QObject {
  Q_OBJECT
 private slots:
  void zeroOnARigidSite() {
    const test::EvaluationSite made = test::makeEvaluationSite(test::rigidWarp(), 10, 0.0);
    const Result<TrueWarp> truth = sampleTrueWarp(made.site.building, made.site.warp);
    QVERIFY(truth);
    const Result<TruthErrors> errors =
        evaluateTruth(made.mesh, made.site.anchors, made.site.building.blueprint, *truth, {});
    QVERIFY(errors);
    QCOMPARE(errors->outside, std::size_t{0});
    for (const MethodErrors& method : errors->methods) QVERIFY(method.statistics.max < 1e-4);
    QVERIFY(errors->heading_rad.max < 1e-4);
  }

  void measuresAKnownError() {
    const test::EvaluationSite made = test::makeEvaluationSite(test::rigidWarp(), 10, 0.0);
    AnchorList moved = made.site.anchors;
    for (Anchor& anchor : moved) anchor.in_slam += Eigen::Vector2d(0.3, 0.4);
    const Result<TrueWarp> truth = sampleTrueWarp(made.site.building, made.site.warp);
    const Result<TruthErrors> errors = evaluateTruth(made.mesh, moved, made.site.building.blueprint, *truth, {});
    QVERIFY(errors);
    for (const MethodErrors& method : errors->methods) QVERIFY(std::abs(method.statistics.mean - 0.5) < 1e-4);
    QVERIFY(errors->heading_rad.max < 1e-4);
  }

  void placesAreFreeAndSpaced() {
    const test::EvaluationSite made = test::makeEvaluationSite(test::bentWarp(), 10);
    const Result<TrueWarp> truth = sampleTrueWarp(made.site.building, made.site.warp);
    const std::vector<TruePlace> places = truePlaces(made.site.building.blueprint, *truth, 0.5);
    QVERIFY(places.size() > 500);
    for (const TruePlace& place : places) {
      QCOMPARE(made.site.building.blueprint.at(place.in_blueprint), CellState::kFree);
      const Pose2 exact = made.site.slamFromBlueprint({place.in_blueprint, 0.0});
      QVERIFY((exact.translation - place.in_slam.translation).norm() < 0.005);
    }
  }

  void otherBuildingIsRefused() {
    const test::EvaluationSite made = test::makeEvaluationSite(test::rigidWarp(), 10);
    const TrueWarp elsewhere = *TrueWarp::create({{1e4, 1e4}, 1.0, 2, 2}, std::vector<TrueWarp::Sample>(4, {0, 0, 0}));
    const Result<TruthErrors> errors =
        evaluateTruth(made.mesh, made.site.anchors, made.site.building.blueprint, elsewhere, {});
    QVERIFY(!errors);
    QCOMPARE(errors.error().code, ErrorCode::kDegenerate);
  }

  void noAnchorsIsAnError() {
    const test::EvaluationSite made = test::makeEvaluationSite(test::rigidWarp(), 10);
    const Result<TrueWarp> truth = sampleTrueWarp(made.site.building, made.site.warp);
    QVERIFY(!evaluateTruth(made.mesh, {}, made.site.building.blueprint, *truth, {}));
  }
};

QTEST_APPLESS_MAIN(TruthErrorTest)
#include "truth_error_test.moc"
