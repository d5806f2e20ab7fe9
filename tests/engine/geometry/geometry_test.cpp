// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include <QtTest>

#include <limits>
#include <random>

#include "cad2slam/geometry/angle.h"
#include "cad2slam/geometry/pose2.h"
#include "cad2slam/geometry/similarity2.h"

namespace cad2slam {

class GeometryTest : public QObject {
  Q_OBJECT
 private slots:
  void wrappedAnglesPointTheSameWay();
  void wrapSurvivesHostileAngles();
  void posesFormAGroup();
  void similarityInverts();
};

void GeometryTest::wrappedAnglesPointTheSameWay() {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> angles(-1e4, 1e4);
  for (int k = 0; k < 10000; ++k) {
    const double angle = angles(random);
    const double wrapped = wrapAngle(angle);
    QVERIFY(wrapped >= -kPi && wrapped < kPi);
    QVERIFY(std::abs(std::sin(wrapped) - std::sin(angle)) < 1e-11);
    QVERIFY(std::abs(std::cos(wrapped) - std::cos(angle)) < 1e-11);
  }
  QCOMPARE(wrapAngle(kPi), -kPi);
  QCOMPARE(wrapAngle(-kPi), -kPi);
}

void GeometryTest::wrapSurvivesHostileAngles() {
  QVERIFY(std::isnan(wrapAngle(std::numeric_limits<double>::infinity())));
  QVERIFY(std::isnan(wrapAngle(std::numeric_limits<double>::quiet_NaN())));
  QVERIFY(std::isfinite(wrapAngle(1e300)));
}

void GeometryTest::posesFormAGroup() {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> number(-50.0, 50.0);
  for (int k = 0; k < 1000; ++k) {
    const Pose2 a{{number(random), number(random)}, number(random)};
    const Pose2 b{{number(random), number(random)}, number(random)};
    const Eigen::Vector2d p(number(random), number(random));
    QVERIFY(((a * b) * p - a * (b * p)).norm() < 1e-10);
    const Pose2 identity = a * a.inverse();
    QVERIFY(identity.translation.norm() < 1e-10 && std::abs(identity.heading) < 1e-12);
    QVERIFY((a.inverse() * (a * p) - p).norm() < 1e-10);
  }
}

void GeometryTest::similarityInverts() {
  const Similarity2 similarity{1.37, 2.9, {4.0, -70.0}};
  const Eigen::Vector2d p(12.5, -3.25);
  QVERIFY((similarity.inverse() * (similarity * p) - p).norm() < 1e-12);
  const Pose2 pose = similarity * Pose2{p, 0.5};
  QVERIFY((pose.translation - similarity * p).norm() < 1e-15);
  QCOMPARE(pose.heading, 3.4);
}

}  // namespace cad2slam

QTEST_GUILESS_MAIN(cad2slam::GeometryTest)
#include "geometry_test.moc"
