// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/simulation/warp_field.h"

#include "cad2slam/simulation/site_generator.h"

#include <Eigen/LU>

#include <QtTest>

#include <algorithm>
#include <cmath>

using namespace cad2slam;

class WarpFieldTest : public QObject {
  Q_OBJECT
 private slots:
  void noStrengthIsARigidMotion();
  void headingIsThatOfTheJacobian();
  void loopClosesWhereTheRouteCloses();
  void tooStrongWarpsAreWeakened();
};

void WarpFieldTest::noStrengthIsARigidMotion() {
  SeededRandom random(4);
  WarpRecipe recipe;
  recipe.slam_from_plan = {{5.0, -7.0}, 2.5};
  const WarpField warp(recipe, {{0, 0}, {10, 0}}, false, {{0, 0}, {10, 5}}, random);
  QVERIFY((warp.slamFromPlan(Eigen::Vector2d(3, 4)) - recipe.slam_from_plan * Eigen::Vector2d(3, 4)).norm() < 1e-12);
  QVERIFY(std::abs(wrapAngle(warp.slamFromPlan(Pose2{{3, 4}, 1.0}).heading - 3.5)) < 1e-6);
}

void WarpFieldTest::headingIsThatOfTheJacobian() {
  const Result<GeneratedSite> site = generateSite(randomSiteRecipe(33));
  QVERIFY(site);
  for (const Eigen::Vector2d& place : freePlaces(site->building.plan, 4.0)) {
    const Eigen::Matrix2d j = site->warp.jacobian(place);
    const double heading = site->warp.slamFromPlan(Pose2{place, 0.0}).heading;
    const Eigen::Matrix2d strain = rotationMatrix(-heading) * j;
    QVERIFY(std::abs(strain(0, 1) - strain(1, 0)) < 1e-6);  // what is left after the rotation is symmetric
    QVERIFY(strain.trace() > 0.0);
  }
}

void WarpFieldTest::loopClosesWhereTheRouteCloses() {
  const std::vector<Eigen::Vector2d> loop = {{0, 0}, {60, 0}, {60, 40}, {0, 40}, {0, 0}};
  const std::vector<Eigen::Vector2d> places = {{0, 0}, {30, 0}, {60, 20}, {30, 40}};
  WarpRecipe recipe;
  recipe.heading_drift_rad = 0.1;
  const auto bend_at_start = [&](bool closed) {
    SeededRandom random(3);
    const WarpField warp(recipe, loop, closed, places, random);
    // With the loop closed, what the robot saw first and last agrees: the map turns smoothly through the start.
    const double before = warp.slamFromPlan(Pose2{{0.0, 8.0}, 0.0}).heading;
    const double after = warp.slamFromPlan(Pose2{{8.0, 0.0}, 0.0}).heading;
    return std::abs(wrapAngle(after - before));
  };
  QVERIFY(bend_at_start(true) < 0.5 * bend_at_start(false));
}

void WarpFieldTest::tooStrongWarpsAreWeakened() {
  WarpRecipe recipe;
  recipe.wave_m = 20.0;
  recipe.wave_length_m = 20.0;
  std::vector<Eigen::Vector2d> places;
  for (int x = 0; x < 40; x += 2) {
    for (int y = 0; y < 30; y += 2) places.emplace_back(x, y);
  }
  SeededRandom random(5);
  const WarpField warp(recipe, {{0, 0}, {40, 0}}, false, places, random);
  QVERIFY(warp.strength() < 0.2);
  for (const Eigen::Vector2d& place : places) {
    const double area = warp.jacobian(place).determinant();
    QVERIFY(area >= 0.75 && area <= 1.3);
  }
}

QTEST_APPLESS_MAIN(WarpFieldTest)
#include "warp_field_test.moc"
