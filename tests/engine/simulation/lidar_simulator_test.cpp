// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/simulation/lidar_simulator.h"

#include <opencv2/core.hpp>

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

using namespace cad2slam;

namespace {

constexpr auto kFree = static_cast<std::uint8_t>(CellState::kFree);
constexpr auto kOccupied = static_cast<std::uint8_t>(CellState::kOccupied);
constexpr auto kUnknown = static_cast<std::uint8_t>(CellState::kUnknown);

/// A free room of `width` x `height` pixels with a wall one pixel thick around it.
cv::Mat room(int width, int height) {
  cv::Mat states(height + 2, width + 2, CV_8UC1, cv::Scalar(kOccupied));
  states(cv::Rect(1, 1, width, height)).setTo(kFree);
  return states;
}

OccupancyGrid makeGrid(const cv::Mat& states, double resolution, const Pose2& origin) {
  return {*MapFrame::create(resolution, states.cols, states.rows, origin), states};
}

/// Way from a point inside an upright box to its border along a direction.
double rangeInBox(const Eigen::Vector2d& from, double direction, const Eigen::Vector2d& low,
                  const Eigen::Vector2d& high) {
  const Eigen::Vector2d unit(std::cos(direction), std::sin(direction));
  double range = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 2; ++axis) {
    if (unit[axis] > 0.0) range = std::min(range, (high[axis] - from[axis]) / unit[axis]);
    if (unit[axis] < 0.0) range = std::min(range, (low[axis] - from[axis]) / unit[axis]);
  }
  return range;
}

}  // namespace

class LidarSimulatorTest : public QObject {
  Q_OBJECT
 private slots:
  void rectangularRoom_data();
  void rectangularRoom();
  void roundRoom();
  void agreesWithFineSampling();
  void beamsAndBearings();
  void unknownIsPassedAndTheOutsideIsOpen();
  void sensorOutsideLooksIn();
  void rangeEndsExactly();
  void sensorInAWall();
  void diagonalWallDoesNotLeak();
  void brokenQueriesMeetNothing();
};

void LidarSimulatorTest::rectangularRoom_data() {
  QTest::addColumn<double>("resolution");
  QTest::addColumn<double>("x");
  QTest::addColumn<double>("y");
  QTest::addColumn<double>("yaw");
  QTest::newRow("at the origin") << 0.05 << 0.0 << 0.0 << 0.0;
  QTest::newRow("shifted") << 0.05 << -12.3 << 45.6 << 0.0;
  QTest::newRow("turned by a right angle") << 0.1 << 3.0 << -2.0 << kPi / 2;
  QTest::newRow("turned") << 0.025 << -5.0 << 7.0 << 0.7;
  QTest::newRow("turned back and far away") << 0.2 << 1e5 << -2e5 << -2.9;
}

void LidarSimulatorTest::rectangularRoom() {
  QFETCH(double, resolution);
  QFETCH(double, x);
  QFETCH(double, y);
  QFETCH(double, yaw);
  const Pose2 origin{{x, y}, yaw};
  const OccupancyGrid grid = makeGrid(room(120, 70), resolution, origin);
  const Eigen::Vector2d low = Eigen::Vector2d(1, 1) * resolution;
  const Eigen::Vector2d high = Eigen::Vector2d(121, 71) * resolution;
  LidarModel model;
  model.range_max_m = 100.0;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0.01, 0.99);
  for (int trial = 0; trial < 20; ++trial) {
    const Eigen::Vector2d in_corner = low + Eigen::Vector2d(unit(random), unit(random)).cwiseProduct(high - low);
    const double heading = 2.0 * kPi * unit(random);
    const Scan scan = simulateScan(grid, {origin * in_corner, heading}, model);
    QCOMPARE(scan.ranges_m.size(), std::size_t{360});
    for (std::size_t beam = 0; beam < scan.ranges_m.size(); ++beam) {
      const double expected = rangeInBox(in_corner, heading + scan.bearings_rad[beam] - yaw, low, high);
      QVERIFY2(std::abs(scan.ranges_m[beam] - expected) < 1e-7, qPrintable(QString::number(scan.ranges_m[beam])));
    }
    const Pose2 corner_from_map = origin.inverse();
    for (const Eigen::Vector2d& hit : scan.hits({origin * in_corner, heading})) {
      const Eigen::Vector2d place = corner_from_map * hit;
      const double to_border = std::min((place - low).cwiseAbs().minCoeff(), (place - high).cwiseAbs().minCoeff());
      QVERIFY(to_border < 1e-7);
    }
  }
}

void LidarSimulatorTest::roundRoom() {
  constexpr double kResolution = 0.02;
  constexpr double kRadius = 4.0;
  cv::Mat states(500, 500, CV_8UC1, cv::Scalar(kOccupied));
  for (int row = 0; row < states.rows; ++row) {
    for (int column = 0; column < states.cols; ++column) {
      const double distance = std::hypot(column + 0.5 - 250.0, row + 0.5 - 250.0) * kResolution;
      if (distance < kRadius) states.at<std::uint8_t>(row, column) = kFree;
    }
  }
  const Pose2 origin{{-5.0, -5.0}, 0.0};
  const OccupancyGrid grid = makeGrid(states, kResolution, origin);
  for (const Eigen::Vector2d& sensor : {Eigen::Vector2d(0, 0), Eigen::Vector2d(1.5, -2.0), Eigen::Vector2d(-3.1, 1)}) {
    const Scan scan = simulateScan(grid, {sensor, 0.3}, {});
    for (const Eigen::Vector2d& hit : scan.hits({sensor, 0.3})) {
      QVERIFY(std::abs(hit.norm() - kRadius) < 1.5 * kResolution);
    }
  }
}

void LidarSimulatorTest::agreesWithFineSampling() {
  constexpr double kResolution = 0.1;
  std::mt19937 random(11);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  cv::Mat states(60, 80, CV_8UC1, cv::Scalar(kFree));
  for (int i = 0; i < 150; ++i) {
    states.at<std::uint8_t>(static_cast<int>(60 * unit(random)), static_cast<int>(80 * unit(random))) = kOccupied;
  }
  const OccupancyGrid grid = makeGrid(states, kResolution, {{2.0, 3.0}, 0.4});
  LidarModel model;
  model.beams = 90;
  for (int trial = 0; trial < 10; ++trial) {
    const Pose2 sensor{Pose2{{2.0, 3.0}, 0.4} * Eigen::Vector2d(8.0 * unit(random), 6.0 * unit(random)), trial * 1.0};
    const Scan scan = simulateScan(grid, sensor, model);
    for (std::size_t beam = 0; beam < scan.ranges_m.size(); ++beam) {
      const double bearing = sensor.heading + scan.bearings_rad[beam];
      const Eigen::Vector2d direction(std::cos(bearing), std::sin(bearing));
      double sampled = 0.0;
      while (sampled < 12.0 &&
             grid.at(Eigen::Vector2d(sensor.translation + sampled * direction)) != CellState::kOccupied) {
        sampled += 1e-3;
      }
      // Sampling can only miss: a grazed corner is seen by the traversal and stepped over by the samples.
      if (sampled < 12.0) {
        QVERIFY(scan.ranges_m[beam] <= sampled + 1e-9);
      }
      if (std::isfinite(scan.ranges_m[beam])) {
        const Eigen::Vector2d hit = sensor.translation + (scan.ranges_m[beam] + 1e-9) * direction;
        QVERIFY(grid.at(hit) == CellState::kOccupied || scan.ranges_m[beam] > sampled - 2e-3);
      }
    }
  }
}

void LidarSimulatorTest::beamsAndBearings() {
  const OccupancyGrid grid = makeGrid(room(40, 40), 0.1, {});
  LidarModel model;
  model.beams = 5;
  model.start_angle_rad = -0.5;
  model.field_of_view_rad = 1.0;
  const Scan scan = simulateScan(grid, {{2.0, 2.0}, 1.0}, model);
  QCOMPARE(scan.bearings_rad.size(), std::size_t{5});
  for (int beam = 0; beam < 5; ++beam) QCOMPARE(scan.bearings_rad[static_cast<std::size_t>(beam)], -0.5 + beam * 0.2);
}

void LidarSimulatorTest::unknownIsPassedAndTheOutsideIsOpen() {
  cv::Mat states(10, 40, CV_8UC1, cv::Scalar(kUnknown));
  states.col(30).setTo(kOccupied);
  const OccupancyGrid grid = makeGrid(states, 0.1, {});
  LidarModel model;
  model.beams = 4;
  const Scan scan = simulateScan(grid, {{1.0, 0.55}, 0.0}, model);  // -pi, -pi/2, 0, pi/2
  QVERIFY(std::isinf(scan.ranges_m[0]));
  QVERIFY(std::isinf(scan.ranges_m[1]));
  QVERIFY(std::abs(scan.ranges_m[2] - 2.0) < 1e-12);
  QVERIFY(std::isinf(scan.ranges_m[3]));
  QCOMPARE(scan.hits({{1.0, 0.55}, 0.0}).size(), std::size_t{1});
}

void LidarSimulatorTest::sensorOutsideLooksIn() {
  const OccupancyGrid grid = makeGrid(room(40, 40), 0.1, {});
  LidarModel model;
  model.beams = 1;
  model.start_angle_rad = 0.0;
  QVERIFY(std::abs(simulateScan(grid, {{-3.0, 2.0}, 0.0}, model).ranges_m[0] - 3.0) < 1e-12);
  QVERIFY(std::isinf(simulateScan(grid, {{-3.0, 2.0}, kPi}, model).ranges_m[0]));
  QVERIFY(std::isinf(simulateScan(grid, {{-3.0, 9.0}, 0.0}, model).ranges_m[0]));
}

void LidarSimulatorTest::rangeEndsExactly() {
  const OccupancyGrid grid = makeGrid(room(40, 40), 0.125, {});  // wall starts at 5.125
  LidarModel model;
  model.beams = 1;
  model.start_angle_rad = 0.0;
  model.range_max_m = 4.125;
  QCOMPARE(simulateScan(grid, {{1.0, 2.0}, 0.0}, model).ranges_m[0], 4.125);
  model.range_max_m = 4.1249;
  QVERIFY(std::isinf(simulateScan(grid, {{1.0, 2.0}, 0.0}, model).ranges_m[0]));
}

void LidarSimulatorTest::sensorInAWall() {
  const OccupancyGrid grid = makeGrid(room(4, 4), 1.0, {});
  for (const double range : simulateScan(grid, {{0.5, 0.5}, 0.0}, {}).ranges_m) QCOMPARE(range, 0.0);
}

void LidarSimulatorTest::diagonalWallDoesNotLeak() {
  cv::Mat states(50, 50, CV_8UC1, cv::Scalar(kFree));
  for (int i = 0; i < 50; ++i) states.at<std::uint8_t>(i, i) = kOccupied;
  const OccupancyGrid grid = makeGrid(states, 1.0, {});
  LidarModel model;
  model.beams = 1;
  model.start_angle_rad = 0.0;
  for (int i = 1; i < 50; ++i) {  // aimed exactly at the corners between two pixels of the wall
    const double x = i - 10.0;
    const double y = 50.0 - i - 10.0;
    QVERIFY(std::abs(simulateScan(grid, {{x, y}, kPi / 4}, model).ranges_m[0] - std::sqrt(200.0)) < 1e-9);
  }
}

void LidarSimulatorTest::brokenQueriesMeetNothing() {
  const OccupancyGrid grid = makeGrid(room(4, 4), 1.0, {});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double range : simulateScan(grid, {{nan, 1.0}, 0.0}, {}).ranges_m) QVERIFY(std::isinf(range));
  for (const double range : simulateScan(grid, {{1e300, -1e300}, 0.0}, {}).ranges_m) QVERIFY(std::isinf(range));
  LidarModel model;
  model.beams = -3;
  QVERIFY(simulateScan(grid, {{2.0, 2.0}, 0.0}, model).ranges_m.empty());
  model.beams = 3;
  model.range_max_m = nan;
  for (const double range : simulateScan(grid, {{2.0, 2.0}, 0.0}, model).ranges_m) QVERIFY(std::isinf(range));
}

QTEST_APPLESS_MAIN(LidarSimulatorTest)
#include "lidar_simulator_test.moc"
