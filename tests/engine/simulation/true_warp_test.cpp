// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/simulation/true_warp.h"

#include <QtTest>

#include <cmath>
#include <limits>

using namespace cad2slam;

namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

/// A rigid motion sampled on 4 x 3 places; the heading passes the jump at pi where `turn` says so.
std::vector<TrueWarp::Sample> rigidSamples(const TrueWarp::Layout& layout, const Pose2& slam_from_blueprint) {
  std::vector<TrueWarp::Sample> samples;
  for (int row = 0; row < layout.rows; ++row) {
    for (int column = 0; column < layout.columns; ++column) {
      const Pose2 pose = slam_from_blueprint * Pose2{layout.first + layout.step_m * Eigen::Vector2d(column, row), 0.0};
      samples.push_back({static_cast<float>(pose.translation.x()), static_cast<float>(pose.translation.y()),
                         static_cast<float>(pose.headingWrapped())});
    }
  }
  return samples;
}

}  // namespace

class TrueWarpTest : public QObject {
  Q_OBJECT
 private slots:
  void reproducesARigidMotion();
  void outsideIsNothing();
  void headingsThatWrapAreAveragedAsDirections();
  void refusals();
};

void TrueWarpTest::reproducesARigidMotion() {
  const TrueWarp::Layout layout{{-2.0, 1.0}, 0.5, 4, 3};
  for (const double turn : {0.0, 1.0, 3.1, -3.14159}) {
    const Pose2 motion{{3.0, -4.0}, turn};
    const Result<TrueWarp> warp = TrueWarp::create(layout, rigidSamples(layout, motion));
    QVERIFY(warp);
    for (const Eigen::Vector2d& at :
         {Eigen::Vector2d(-2, 1), Eigen::Vector2d(-0.5, 2.0), Eigen::Vector2d(-1.3, 1.7), Eigen::Vector2d(-1, 2)}) {
      const auto pose = warp->slamFromBlueprint({at, 0.4});
      QVERIFY(pose.has_value());
      QVERIFY((pose->translation - motion * at).norm() < 1e-5);
      QVERIFY(std::abs(wrapAngle(pose->heading - 0.4 - turn)) < 1e-6);
    }
  }
}

void TrueWarpTest::outsideIsNothing() {
  const TrueWarp::Layout layout{{0.0, 0.0}, 1.0, 3, 2};
  std::vector<TrueWarp::Sample> samples(6, {1.0F, 2.0F, 0.0F});
  samples[2] = {kNaN, kNaN, kNaN};
  const Result<TrueWarp> warp = TrueWarp::create(layout, samples);
  QVERIFY(warp);
  QVERIFY(warp->slamFromBlueprint({{0.5, 0.5}, 0.0}).has_value());
  QVERIFY(warp->slamFromBlueprint({{1.0, 0.5}, 0.0}).has_value());
  QVERIFY(!warp->slamFromBlueprint({{1.5, 0.5}, 0.0}).has_value());
  QVERIFY(!warp->slamFromBlueprint({{-0.01, 0.5}, 0.0}).has_value());
  QVERIFY(!warp->slamFromBlueprint({{0.5, 1.01}, 0.0}).has_value());
  QVERIFY(!warp->slamFromBlueprint({{std::nan(""), 0.5}, 0.0}).has_value());
  QVERIFY(!warp->slamFromBlueprint({{1e300, 0.5}, 0.0}).has_value());
}

void TrueWarpTest::headingsThatWrapAreAveragedAsDirections() {
  const TrueWarp::Layout layout{{0.0, 0.0}, 1.0, 2, 2};
  const Result<TrueWarp> warp = TrueWarp::create(layout, {{0, 0, 3.1F}, {1, 0, -3.1F}, {0, 1, 3.1F}, {1, 1, -3.1F}});
  QVERIFY(warp);
  QVERIFY(std::abs(wrapAngle(warp->slamFromBlueprint({{0.5, 0.5}, 0.0})->heading - kPi)) < 1e-6);
}

void TrueWarpTest::refusals() {
  const std::vector<TrueWarp::Sample> four(4, {0, 0, 0});
  QVERIFY(!TrueWarp::create({{0, 0}, 0.0, 2, 2}, four));
  QVERIFY(!TrueWarp::create({{0, 0}, std::nan(""), 2, 2}, four));
  QVERIFY(!TrueWarp::create({{0, 0}, 1.0, 1, 4}, four));
  QVERIFY(!TrueWarp::create({{0, 0}, 1.0, 3, 2}, four));
  QVERIFY(!TrueWarp::create({{0, 0}, 1.0, -2, -2}, four));
  QVERIFY(!TrueWarp::create({{std::nan(""), 0}, 1.0, 2, 2}, four));
  std::vector<TrueWarp::Sample> infinite = four;
  infinite[1].y = std::numeric_limits<float>::infinity();
  QVERIFY(!TrueWarp::create({{0, 0}, 1.0, 2, 2}, infinite));
}

QTEST_APPLESS_MAIN(TrueWarpTest)
#include "true_warp_test.moc"
