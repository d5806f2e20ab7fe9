// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/exports/feature_warp.h"

#include <QtTest>

#include <cmath>
#include <random>

#include "support/bent_hall.h"

namespace cad2slam {
namespace {

using Eigen::Vector2d;
using test::bentHall;

double distanceToLine(const Vector2d& place, const PointList& line) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t k = 1; k < line.size(); ++k) {
    const Vector2d along = line[k] - line[k - 1];
    const double part = std::clamp((place - line[k - 1]).dot(along) / along.squaredNorm(), 0.0, 1.0);
    nearest = std::min(nearest, (place - line[k - 1] - part * along).norm());
  }
  return nearest;
}

}  // namespace

class FeatureWarpTest : public QObject {
  Q_OBJECT
 private slots:
  void edgesKeepTheChordError();
  void straightEdgesStayShort();
  void namesWhatHasNoAnswer();
  void crossings_data();
  void crossings();
};

void FeatureWarpTest::edgesKeepTheChordError() {
  const Projector projector = bentHall();
  Feature path;
  path.kind = FeatureKind::kPath;
  path.parts = {{{0.5, 0.5}, {19.5, 9.5}, {19.0, 0.5}}};
  for (const double error : {0.2, 0.02, 0.002}) {
    const Result<WarpedFeatures> warped = warpFeatures(projector, {path}, {WarpDirection::kToSlam, {}, error});
    QVERIFY(warped.has_value());
    const PointList& line = warped->features[0].parts[0];
    for (int k = 0; k <= 10000; ++k) {
      const Vector2d place = path.parts[0][0] + k / 10000.0 * (path.parts[0][1] - path.parts[0][0]);
      QVERIFY(distanceToLine(projector.slamFromBlueprint({place, 0.0}).pose.translation, line) <= error);
    }
    QVERIFY(static_cast<double>(line.size()) < 40.0 / std::sqrt(error));
    QVERIFY(warped->largest_sagitta_m > 0.5);
    QCOMPARE(warped->vertices_after, line.size());
  }
}

void FeatureWarpTest::straightEdgesStayShort() {
  ProjectorData data;
  for (std::int32_t column = 0; column < 20; ++column) {
    data.node_tile.push_back({column, 0});
    data.node_blueprint.emplace_back(column + 0.5, 0.5);
    data.node_slam.push_back({{-0.5 - 0.0, column + 0.5}, 3.14159265358979 / 2});
    data.node_stretch.emplace_back(0.0, 0.0);
  }
  Feature path;
  path.kind = FeatureKind::kPath;
  path.parts = {{{0.5, 0.5}, {19.5, 0.5}}};
  const Result<WarpedFeatures> warped = warpFeatures(*Projector::create(data), {path}, {});
  QCOMPARE(warped->features[0].parts[0].size(), std::size_t{2});
}

void FeatureWarpTest::namesWhatHasNoAnswer() {
  const Projector projector = bentHall();
  Feature place;
  place.parts = {{{90.0, 1.0}}};
  place.name = "dock";
  const Result<WarpedFeatures> warped = warpFeatures(projector, {place}, {});
  QVERIFY(!warped.has_value() && warped.error().code == ErrorCode::kOutOfDomain);
  QVERIFY(warped.error().where.find("dock") != std::string::npos);
  QVERIFY(warpFeatures(projector, {place}, {WarpDirection::kToSlam, OutsidePolicy::kRigid, 0.01}).has_value());
  Feature endless;
  endless.kind = FeatureKind::kPath;
  endless.parts = {{{1.0, 1.0}, {1e15, 1.0}}};
  QVERIFY(!warpFeatures(projector, {endless}, {WarpDirection::kToSlam, OutsidePolicy::kRigid, 0.01}).has_value());
  for (const double error : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
    QVERIFY(!warpFeatures(projector, {}, {WarpDirection::kToSlam, OutsidePolicy::kRigid, error}).has_value());
  }
}

void FeatureWarpTest::crossings_data() {
  QTest::addColumn<QVector<QPointF>>("ring");
  QTest::addColumn<bool>("crosses");
  QTest::newRow("triangle") << QVector<QPointF>{{0, 0}, {1, 0}, {0, 1}} << false;
  QTest::newRow("square") << QVector<QPointF>{{0, 0}, {1, 0}, {1, 1}, {0, 1}} << false;
  QTest::newRow("bow tie") << QVector<QPointF>{{0, 0}, {1, 1}, {1, 0}, {0, 1}} << true;
  QTest::newRow("touches itself") << QVector<QPointF>{{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}} << true;
  QTest::newRow("comb") << QVector<QPointF>{{0, 0}, {9, 0}, {9, 5}, {7, 1}, {5, 5}, {3, 1}, {1, 5}} << false;
}

void FeatureWarpTest::crossings() {
  QFETCH(QVector<QPointF>, ring);
  QFETCH(bool, crosses);
  PointList places;
  for (const QPointF& point : ring) places.emplace_back(point.x(), point.y());
  for (std::size_t turn = 0; turn < places.size(); ++turn) {
    std::rotate(places.begin(), places.begin() + 1, places.end());
    QCOMPARE(crossesItself(places), crosses);
    PointList backwards(places.rbegin(), places.rend());
    QCOMPARE(crossesItself(backwards), crosses);
  }
}

}  // namespace cad2slam

QTEST_GUILESS_MAIN(cad2slam::FeatureWarpTest)
#include "feature_warp_test.moc"
