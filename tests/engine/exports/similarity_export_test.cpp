// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/exports/similarity_export.h"

#include <QtTest>

#include "support/bent_hall.h"

namespace cad2slam {
namespace {

using Eigen::Vector2d;

Feature path(PointList places, std::string name) {
  Feature feature;
  feature.kind = FeatureKind::kPath;
  feature.parts = {std::move(places)};
  feature.name = std::move(name);
  return feature;
}

}  // namespace

class SimilarityExportTest : public QObject {
  Q_OBJECT
 private slots:
  void aSimilarityIsFound();
  void whatIsLeftIsTold();
  void lanesThatMatterAreFitted();
  void wrongInputIsRefused();
};

void SimilarityExportTest::aSimilarityIsFound() {
  const Projector projector = *Projector::create(test::straightHallData(1.05, {{4.0, -9.0}, 2.0}));
  const Result<LevelTransform> fit = fitLevelTransform(projector, {}, 0.5, 10);
  QVERIFY(fit);
  QVERIFY(std::abs(fit->slam_from_blueprint.scale - 1.05) < 1e-9);
  QVERIFY(std::abs(fit->slam_from_blueprint.heading - 2.0) < 1e-9);
  QVERIFY((fit->slam_from_blueprint.translation - Vector2d(4.0, -9.0)).norm() < 1e-8);
  QVERIFY(fit->rms_m < 1e-9 && fit->max_m < 1e-9);
  QCOMPARE(fit->places, std::size_t{200});
  QCOMPARE(fit->references.size(), std::size_t{10});
}

void SimilarityExportTest::whatIsLeftIsTold() {
  const Projector projector = test::bentHall();
  const LevelTransform fit = *fitLevelTransform(projector, {}, 0.5, 24);
  QVERIFY(fit.max_m > fit.rms_m && fit.rms_m > 0.1);
  const Vector2d exact = projector.slamFromBlueprint({fit.worst_in_blueprint, 0.0}).pose.translation;
  QVERIFY(std::abs((exact - fit.slam_from_blueprint * fit.worst_in_blueprint).norm() - fit.max_m) < 1e-9);
  double squares = 0.0;
  for (const Vector2d& middle : projector.tileMiddles()) {
    const Vector2d image = projector.slamFromBlueprint({middle, 0.0}).pose.translation;
    squares += (image - fit.slam_from_blueprint * middle).squaredNorm();
    QVERIFY((image - fit.slam_from_blueprint * middle).norm() <= fit.max_m + 1e-12);
  }
  QVERIFY(std::abs(std::sqrt(squares / 200.0) - fit.rms_m) < 1e-9);
}

void SimilarityExportTest::lanesThatMatterAreFitted() {
  // Along one short lane the bend hardly shows; over the whole hall it does.
  const Projector projector = test::bentHall();
  const FeatureList lane = {path({{2.0, 5.0}, {4.0, 5.0}}, "short")};
  const LevelTransform near = *fitLevelTransform(projector, lane, 0.1, 5);
  const LevelTransform all = *fitLevelTransform(projector, {}, 0.1, 5);
  QVERIFY(near.max_m < 0.1 * all.max_m);
  QCOMPARE(near.places, std::size_t{21});
  const LevelTransform two = *fitLevelTransform(
      projector, {path({{2.0, 5.0}, {4.0, 5.0}}, "short"), path({{1.0, 1.0}, {19.0, 9.0}}, "long")}, 0.1, 5);
  QCOMPARE(QString::fromStdString(two.worst_name), QString("long"));
  for (const PointPair& pair : two.references) {
    QVERIFY((projector.slamFromBlueprint({pair.source, 0.0}).pose.translation - pair.target).norm() < 1e-12);
  }
}

void SimilarityExportTest::wrongInputIsRefused() {
  const Projector projector = test::bentHall();
  const FeatureList away = {path({{2.0, 5.0}, {40.0, 5.0}}, "away")};
  const Result<LevelTransform> outside = fitLevelTransform(projector, away, 0.5, 5);
  QVERIFY(!outside);
  QCOMPARE(outside.error().code, ErrorCode::kOutOfDomain);
  QCOMPARE(QString::fromStdString(outside.error().where), QString("away"));
  const FeatureList endless = {path({{2.0, 5.0}, {1e300, 5.0}}, "endless")};
  QVERIFY(!fitLevelTransform(projector, endless, 1e-3, 5));
  QVERIFY(!fitLevelTransform(projector, {}, 0.0, 5));
  QVERIFY(!fitLevelTransform(projector, {}, std::numeric_limits<double>::quiet_NaN(), 5));
  QVERIFY(!fitLevelTransform(projector, {}, 0.5, 1));
  Feature point;
  point.parts = {{{3.0, 3.0}}};
  QVERIFY(!fitLevelTransform(projector, {point}, 0.5, 5));
}

}  // namespace cad2slam

QTEST_APPLESS_MAIN(cad2slam::SimilarityExportTest)
#include "similarity_export_test.moc"
