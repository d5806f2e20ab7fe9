// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/solver/global_fit.h"

#include <QtTest>

#include <limits>
#include <random>

namespace cad2slam {
namespace {

using Eigen::Vector2d;

/// Anchors over 40 x 25 m, put into the SLAM map by a similarity and clicked with noise.
AnchorList anchorsOf(const Similarity2& slam_from_blueprint, int count, double noise_m, unsigned seed = 1) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  std::normal_distribution<double> noise(0.0, 1.0);
  AnchorList anchors;
  for (int k = 0; k < count; ++k) {
    Anchor anchor;
    anchor.id = k;
    anchor.in_blueprint = {40.0 * part(random) - 5.0, 25.0 * part(random)};
    anchor.in_slam = slam_from_blueprint * anchor.in_blueprint + noise_m * Vector2d(noise(random), noise(random));
    anchors.push_back(anchor);
  }
  return anchors;
}

}  // namespace

class GlobalFitTest : public QObject {
  Q_OBJECT
 private slots:
  void exactAtAnyRotation();
  void fixedScaleIsKept();
  void toScaleLiesBetweenOneAndLeastSquares_data();
  void toScaleLiesBetweenOneAndLeastSquares();
  void manyGoodAnchorsOverruleThePlan();
  void oneOutlierDoesNotMatter();
  void fewAnchors();
  void disabledAnchorsAreNotUsed();
  void refusals();
  void distinctPlacesAreCountedUpToThree();
};

void GlobalFitTest::exactAtAnyRotation() {
  for (double heading = -3.1; heading < 3.2; heading += 0.31) {
    const Similarity2 truth{1.37, heading, {-30.0, 12.0}};
    const Result<Similarity2> fit = fitGlobally(anchorsOf(truth, 6, 0.0), {ScaleRule::kLeastSquares, 1.0});
    QVERIFY(fit.has_value());
    QVERIFY(std::abs(fit->scale - truth.scale) < 1e-12);
    QVERIFY(std::abs(wrapAngle(fit->heading - heading)) < 1e-12);
    QVERIFY((fit->translation - truth.translation).norm() < 1e-10);
  }
}

void GlobalFitTest::fixedScaleIsKept() {
  const Similarity2 truth{1.37, 0.4, {3.0, -2.0}};
  for (const int count : {1, 2, 3, 20}) {
    const Result<Similarity2> fit = fitGlobally(anchorsOf(truth, count, 0.05), {ScaleRule::kFixed, 1.25});
    QVERIFY(fit.has_value());
    QCOMPARE(fit->scale, 1.25);
  }
}

void GlobalFitTest::toScaleLiesBetweenOneAndLeastSquares_data() {
  QTest::addColumn<double>("scale");
  QTest::addColumn<int>("count");
  for (const double scale : {0.8, 0.97, 0.995, 1.004, 1.02, 1.5}) {
    for (const int count : {3, 4, 8, 40}) QTest::addRow("%g with %d anchors", scale, count) << scale << count;
  }
}

void GlobalFitTest::toScaleLiesBetweenOneAndLeastSquares() {
  QFETCH(double, scale);
  QFETCH(int, count);
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const AnchorList anchors = anchorsOf({scale, 1.0, {0.0, 0.0}}, count, 0.3, seed);
    const double free = fitGlobally(anchors, {ScaleRule::kLeastSquares, 1.0})->scale;
    const double shrunk = fitGlobally(anchors, {ScaleRule::kToScale, 1.0})->scale;
    QVERIFY(std::min(1.0, free) <= shrunk && shrunk <= std::max(1.0, free));
  }
}

void GlobalFitTest::manyGoodAnchorsOverruleThePlan() {
  const Result<Similarity2> fit = fitGlobally(anchorsOf({1.37, -2.0, {0.0, 0.0}}, 40, 0.1), {ScaleRule::kToScale, 1.0});
  QVERIFY(std::abs(fit->scale - 1.37) < 0.005);
  // Click noise alone does not: there the plan's claim is worth more than four anchors.
  const AnchorList few = anchorsOf({1.0, -2.0, {0.0, 0.0}}, 4, 0.5);
  const double free = fitGlobally(few, {ScaleRule::kLeastSquares, 1.0})->scale;
  const double shrunk = fitGlobally(few, {ScaleRule::kToScale, 1.0})->scale;
  QVERIFY(std::abs(shrunk - 1.0) < 0.5 * std::abs(free - 1.0));
}

void GlobalFitTest::oneOutlierDoesNotMatter() {
  for (const ScaleRule rule : {ScaleRule::kToScale, ScaleRule::kLeastSquares, ScaleRule::kFixed}) {
    AnchorList anchors = anchorsOf({1.0, 2.5, {10.0, 4.0}}, 20, 0.05);
    const Similarity2 clean = *fitGlobally(anchors, {rule, 1.0});
    anchors[7].in_slam += Vector2d(-25.0, 15.0);
    const Similarity2 spoilt = *fitGlobally(anchors, {rule, 1.0});
    for (const Anchor& anchor : anchors) {
      QVERIFY((spoilt * anchor.in_blueprint - clean * anchor.in_blueprint).norm() < 0.1);
    }
  }
}

void GlobalFitTest::fewAnchors() {
  const Similarity2 truth{1.2, 0.8, {3.0, -2.0}};
  for (const ScaleRule rule : {ScaleRule::kToScale, ScaleRule::kLeastSquares}) {
    // One place, even if clicked twice, gives a translation; the plan is put down unturned.
    AnchorList one = anchorsOf(truth, 1, 0.0);
    const Result<Similarity2> translation = fitGlobally(one, {rule, 1.0});
    QVERIFY(translation.has_value());
    QCOMPARE(translation->scale, 1.0);
    QCOMPARE(translation->heading, 0.0);
    QVERIFY((*translation * one[0].in_blueprint - one[0].in_slam).norm() < 1e-12);
    one.push_back(one[0]);
    one[1].in_slam += Vector2d(0.2, 0.0);
    const Result<Similarity2> mean = fitGlobally(one, {rule, 1.0});
    QVERIFY((*mean * one[0].in_blueprint - one[0].in_slam - Vector2d(0.1, 0.0)).norm() < 1e-12);
  }
  const AnchorList two = anchorsOf(truth, 2, 0.0);
  QCOMPARE(fitGlobally(two, {ScaleRule::kToScale, 1.0})->scale, 1.0);
  QVERIFY(std::abs(fitGlobally(two, {ScaleRule::kLeastSquares, 1.0})->scale - 1.2) < 1e-12);
  QVERIFY(std::abs(fitGlobally(two, {ScaleRule::kToScale, 1.0})->heading - 0.8) < 1e-12);
}

void GlobalFitTest::disabledAnchorsAreNotUsed() {
  AnchorList anchors = anchorsOf({1.0, 2.5, {10.0, 4.0}}, 8, 0.05);
  const Similarity2 before = *fitGlobally(anchors, {});
  Anchor disabled = anchors[0];
  disabled.enabled = false;
  disabled.in_slam = {900.0, 900.0};
  anchors.push_back(disabled);
  const Similarity2 after = *fitGlobally(anchors, {});
  QCOMPARE(after.scale, before.scale);
  QCOMPARE(after.heading, before.heading);
}

void GlobalFitTest::refusals() {
  AnchorList anchors = anchorsOf({}, 4, 0.0);
  for (const double scale : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(), HUGE_VAL}) {
    const Result<Similarity2> fit = fitGlobally(anchors, {ScaleRule::kFixed, scale});
    QVERIFY(!fit.has_value());
    QVERIFY(fit.error().code == ErrorCode::kOutOfDomain);
  }
  for (Anchor& anchor : anchors) anchor.enabled = false;
  for (const AnchorList& none : {AnchorList{}, anchors}) {
    const Result<Similarity2> fit = fitGlobally(none, {});
    QVERIFY(!fit.has_value());
    QVERIFY(fit.error().code == ErrorCode::kDegenerate);
  }
}

void GlobalFitTest::distinctPlacesAreCountedUpToThree() {
  AnchorList anchors = anchorsOf({}, 5, 0.0);
  QCOMPARE(distinctPlaces({}), 0);
  QCOMPARE(distinctPlaces(anchors), 3);
  for (Anchor& anchor : anchors) anchor.in_blueprint = {1.0, 1.0};
  QCOMPARE(distinctPlaces(anchors), 1);
  anchors[4].in_blueprint = {1.0, 1.5};
  QCOMPARE(distinctPlaces(anchors), 2);
  anchors[4].enabled = false;
  QCOMPARE(distinctPlaces(anchors), 1);
}

}  // namespace cad2slam

QTEST_GUILESS_MAIN(cad2slam::GlobalFitTest)
#include "global_fit_test.moc"
