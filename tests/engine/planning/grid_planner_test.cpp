// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/planning/grid_planner.h"

#include <opencv2/core.hpp>

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

using namespace cad2slam;

namespace {

constexpr auto kFree = static_cast<std::uint8_t>(CellState::kFree);
constexpr auto kOccupied = static_cast<std::uint8_t>(CellState::kOccupied);
constexpr auto kUnknown = static_cast<std::uint8_t>(CellState::kUnknown);
constexpr double kNever = std::numeric_limits<double>::infinity();

PlannerSettings shortestPath() {
  PlannerSettings settings;
  settings.clearance_cost = 0.0;
  return settings;
}

cv::Mat randomCells(int width, int height, double wall_share, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  cv::Mat states(height, width, CV_8UC1, cv::Scalar(kFree));
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      if (unit(random) < wall_share) states.at<std::uint8_t>(row, column) = unit(random) < 0.8 ? kOccupied : kUnknown;
    }
  }
  return states;
}

/// Length [px] of the shortest way on the 8-connected grid from one pixel to all others, by relaxing every step until
/// nothing changes (Bellman and Ford).
cv::Mat bruteForceLengths(const cv::Mat& states, cv::Point start) {
  cv::Mat length(states.size(), CV_64FC1, cv::Scalar(kNever));
  length.at<double>(start) = 0.0;
  const auto is_free = [&](int column, int row) {
    return column >= 0 && row >= 0 && column < states.cols && row < states.rows &&
           states.at<std::uint8_t>(row, column) == kFree;
  };
  for (bool changed = true; changed;) {
    changed = false;
    for (int row = 0; row < states.rows; ++row) {
      for (int column = 0; column < states.cols; ++column) {
        if (!is_free(column, row)) continue;
        for (int dr = -1; dr <= 1; ++dr) {
          for (int dc = -1; dc <= 1; ++dc) {
            if (!is_free(column + dc, row + dr) || !is_free(column + dc, row) || !is_free(column, row + dr)) continue;
            const double candidate = length.at<double>(row + dr, column + dc) + std::hypot(dc, dr);
            if (candidate < length.at<double>(row, column) - 1e-12) {
              length.at<double>(row, column) = candidate;
              changed = true;
            }
          }
        }
      }
    }
  }
  return length;
}

double polylineLength(const PlannedPath& path) {
  double length = 0.0;
  for (std::size_t i = 1; i < path.poses.size(); ++i) {
    length += (path.poses[i].translation - path.poses[i - 1].translation).norm();
  }
  return length;
}

}  // namespace

class GridPlannerTest : public QObject {
  Q_OBJECT
 private slots:
  void optimalOnRandomGrids_data();
  void optimalOnRandomGrids();
  void straightThroughAnEmptyHall();
  void aLargeMapIsSearchedOnACoarserGrid();
  void aroundACorner();
  void keepsClearWhereThereIsRoom();
  void radiusClosesNarrowDoors();
  void turnedFrame();
  void posesFollowThePath();
  void startIsGoal();
  void refusals_data();
  void refusals();
};

void GridPlannerTest::optimalOnRandomGrids_data() {
  QTest::addColumn<double>("wall_share");
  QTest::newRow("sparse") << 0.1;
  QTest::newRow("dense") << 0.3;
  QTest::newRow("maze") << 0.4;
}

void GridPlannerTest::optimalOnRandomGrids() {
  QFETCH(double, wall_share);
  constexpr double kResolution = 0.25;
  int reached = 0;
  for (unsigned seed = 0; seed < 60; ++seed) {
    cv::Mat states = randomCells(24, 17, wall_share, seed);
    const cv::Point start(2, 14);
    states.at<std::uint8_t>(start) = kFree;
    const MapFrame frame = *MapFrame::create(kResolution, states.cols, states.rows, {{-3.0, 8.0}, 0.0});
    const OccupancyGrid grid(frame, states);
    const cv::Mat lengths = bruteForceLengths(states, start);
    const Eigen::Vector2d start_m = frame.metricFromPixel({start.x + 0.5, start.y + 0.5});
    for (const cv::Point goal : {cv::Point(21, 2), cv::Point(12, 8), cv::Point(3, 1), cv::Point(23, 16)}) {
      if (states.at<std::uint8_t>(goal) != kFree) continue;
      const Eigen::Vector2d goal_m = frame.metricFromPixel({goal.x + 0.5, goal.y + 0.5});
      const Result<PlannedPath> path = planPath(grid, start_m, goal_m, shortestPath());
      const double expected = lengths.at<double>(goal) * kResolution;
      if (std::isinf(expected)) {
        QVERIFY(!path);
        QCOMPARE(path.error().code, ErrorCode::kDegenerate);
        continue;
      }
      ++reached;
      QVERIFY2(path, path ? "" : path.error().message.c_str());
      QVERIFY(std::abs(path->grid_cost_m - expected) < 1e-4);
      QVERIFY(path->length_m <= expected + 1e-4);
      QVERIFY(path->length_m >= (goal_m - start_m).norm() - 1e-9);
      for (const Pose2& pose : path->poses) QCOMPARE(grid.at(pose.translation), CellState::kFree);
    }
  }
  QVERIFY(reached > 0);
}

void GridPlannerTest::straightThroughAnEmptyHall() {
  const cv::Mat states(200, 300, CV_8UC1, cv::Scalar(kFree));
  const OccupancyGrid grid(*MapFrame::create(0.1, states.cols, states.rows, {}), states);
  const Eigen::Vector2d start(2.03, 3.01);
  const Eigen::Vector2d goal(27.77, 15.55);
  const Result<PlannedPath> path = planPath(grid, start, goal, shortestPath());
  QVERIFY(path);
  QVERIFY(std::abs(path->length_m - (goal - start).norm()) < 1e-9);
}

void GridPlannerTest::aLargeMapIsSearchedOnACoarserGrid() {
  cv::Mat states(2000, 15'000, CV_8UC1, cv::Scalar(kFree));  // 150 x 20 m, 30 million pixels
  states.col(7000).setTo(kOccupied);                         // a wall of one pixel,
  states(cv::Rect(7000, 1801, 1, 90)).setTo(kFree);          // and a door of 0.9 m
  const OccupancyGrid grid(*MapFrame::create(0.01, states.cols, states.rows, {{5.0, -3.0}, 0.2}), states);
  const Eigen::Vector2d start = grid.frame().metricFromPixel({6500.3, 300.7});
  const Eigen::Vector2d goal = grid.frame().metricFromPixel({7500.2, 310.1});
  const Result<PlannedPath> path = planPath(grid, start, goal, shortestPath());
  QVERIFY(path);
  QVERIFY(path->poses.front().translation == start && path->poses.back().translation == goal);
  for (const Pose2& pose : path->poses) QCOMPARE(grid.at(pose.translation), CellState::kFree);
  const Eigen::Vector2d door = grid.frame().metricFromPixel({7000.5, 1801.0});
  const double through_door = (door - start).norm() + (goal - door).norm();
  QVERIFY(path->length_m >= through_door && path->length_m < through_door * 1.02);
}

void GridPlannerTest::aroundACorner() {
  cv::Mat states(100, 100, CV_8UC1, cv::Scalar(kFree));
  states(cv::Rect(0, 40, 60, 20)).setTo(kOccupied);  // from x = 0 to 6 m, y = 4 to 6 m
  const OccupancyGrid grid(*MapFrame::create(0.1, 100, 100, {}), states);
  const Eigen::Vector2d start(1.0, 1.0);
  const Eigen::Vector2d goal(1.0, 9.0);
  const Result<PlannedPath> path = planPath(grid, start, goal, shortestPath());
  QVERIFY(path);
  const double around_corners = 2.0 * std::hypot(5.0, 3.0) + 2.0;
  QVERIFY(path->length_m >= around_corners - 1e-9);
  QVERIFY(path->length_m <= around_corners * 1.03);
}

void GridPlannerTest::keepsClearWhereThereIsRoom() {
  cv::Mat states(60, 200, CV_8UC1, cv::Scalar(kFree));
  states(cv::Rect(40, 25, 120, 35)).setTo(kOccupied);  // the way leads along the edge of a block
  const OccupancyGrid grid(*MapFrame::create(0.1, 200, 60, {}), states);
  PlannerSettings settings;
  settings.wanted_clearance_m = 0.8;
  const Result<PlannedPath> near = planPath(grid, {1.0, 3.0}, {19.0, 3.0}, shortestPath());
  const Result<PlannedPath> clear = planPath(grid, {1.0, 3.0}, {19.0, 3.0}, settings);
  QVERIFY(near && clear);
  const auto least_clearance = [](const PlannedPath& path) {
    double least = kNever;
    for (const Pose2& pose : path.poses) {
      if (pose.translation.x() > 6.0 && pose.translation.x() < 14.0)
        least = std::min(least, pose.translation.y() - 3.5);
    }
    return least;
  };
  QVERIFY(least_clearance(*near) < 0.2);
  QVERIFY(least_clearance(*clear) > 0.6);
  QVERIFY(clear->length_m > near->length_m);
}

void GridPlannerTest::radiusClosesNarrowDoors() {
  cv::Mat states(60, 60, CV_8UC1, cv::Scalar(kFree));
  states.row(30).setTo(kOccupied);
  states(cv::Rect(10, 30, 8, 1)).setTo(kFree);  // 0.8 m
  const OccupancyGrid grid(*MapFrame::create(0.1, 60, 60, {}), states);
  PlannerSettings settings;
  settings.robot_radius_m = 0.3;
  QVERIFY(planPath(grid, {3.0, 1.0}, {3.0, 5.0}, settings));
  settings.robot_radius_m = 0.5;
  const Result<PlannedPath> refused = planPath(grid, {3.0, 1.0}, {3.0, 5.0}, settings);
  QVERIFY(!refused);
  QCOMPARE(refused.error().code, ErrorCode::kDegenerate);
}

void GridPlannerTest::turnedFrame() {
  cv::Mat states(100, 100, CV_8UC1, cv::Scalar(kFree));
  states(cv::Rect(30, 0, 10, 80)).setTo(kOccupied);
  const Pose2 origin{{100.0, -50.0}, 2.2};
  const OccupancyGrid upright(*MapFrame::create(0.1, 100, 100, {}), states);
  const OccupancyGrid turned(*MapFrame::create(0.1, 100, 100, origin), states);
  const Eigen::Vector2d start(1.0, 8.0);
  const Eigen::Vector2d goal(8.0, 9.0);
  const Result<PlannedPath> expected = planPath(upright, start, goal);
  const Result<PlannedPath> path = planPath(turned, origin * start, origin * goal);
  QVERIFY(expected && path);
  QCOMPARE(path->poses.size(), expected->poses.size());
  for (std::size_t i = 0; i < path->poses.size(); ++i) {
    const Pose2 placed = origin * expected->poses[i];
    QVERIFY((placed.translation - path->poses[i].translation).norm() < 1e-6);
    QVERIFY(std::abs(wrapAngle(placed.heading - path->poses[i].heading)) < 1e-6);
  }
}

void GridPlannerTest::posesFollowThePath() {
  cv::Mat states = randomCells(80, 80, 0.05, 3);
  states.at<std::uint8_t>(5, 5) = kFree;
  states.at<std::uint8_t>(70, 74) = kFree;
  const OccupancyGrid grid(*MapFrame::create(0.25, 80, 80, {}), states);
  PlannerSettings settings;
  settings.step_m = 0.03;
  const Eigen::Vector2d start(5 * 0.25 + 0.1, 20.0 - 5.5 * 0.25);
  const Eigen::Vector2d goal(74 * 0.25 + 0.07, 20.0 - 70.5 * 0.25);
  const Result<PlannedPath> path = planPath(grid, start, goal, settings);
  QVERIFY(path);
  QCOMPARE(path->poses.front().translation, start);
  QCOMPARE(path->poses.back().translation, goal);
  QVERIFY(polylineLength(*path) <= path->length_m + 1e-9);
  QVERIFY(polylineLength(*path) >= path->length_m * 0.999);
  for (std::size_t i = 1; i < path->poses.size(); ++i) {
    const Eigen::Vector2d step = path->poses[i].translation - path->poses[i - 1].translation;
    QVERIFY(step.norm() <= settings.step_m + 1e-9);
    const Eigen::Vector2d ahead(std::cos(path->poses[i].heading), std::sin(path->poses[i].heading));
    QVERIFY(step.dot(ahead) > 0.0);
  }
}

void GridPlannerTest::startIsGoal() {
  const cv::Mat states(10, 10, CV_8UC1, cv::Scalar(kFree));
  const OccupancyGrid grid(*MapFrame::create(0.1, 10, 10, {}), states);
  const Result<PlannedPath> path = planPath(grid, {0.52, 0.5}, {0.52, 0.5});
  QVERIFY(path);
  QCOMPARE(path->length_m, 0.0);
  QCOMPARE(path->poses.size(), std::size_t{1});
  QCOMPARE(path->poses.front().translation, Eigen::Vector2d(0.52, 0.5));
}

void GridPlannerTest::refusals_data() {
  QTest::addColumn<double>("start_x");
  QTest::addColumn<double>("goal_x");
  QTest::addColumn<double>("step");
  QTest::addColumn<double>("radius");
  QTest::addColumn<int>("code");
  QTest::addColumn<QString>("part");
  const int out_of_domain = static_cast<int>(ErrorCode::kOutOfDomain);
  QTest::newRow("start in a wall") << 5.05 << 9.0 << 0.1 << 0.0 << out_of_domain
                                   << "start (5.05, 1.00) lies inside a wall";
  QTest::newRow("goal in a wall") << 1.0 << 5.05 << 0.1 << 0.0 << out_of_domain
                                  << "goal (5.05, 1.00) lies inside a wall";
  QTest::newRow("goal unknown") << 1.0 << 7.05 << 0.1 << 0.0 << out_of_domain << "unknown";
  QTest::newRow("start outside") << -0.1 << 9.0 << 0.1 << 0.0 << out_of_domain << "outside";
  QTest::newRow("goal outside") << 1.0 << 1e300 << 0.1 << 0.0 << out_of_domain << "outside";
  QTest::newRow("goal not a number") << 1.0 << std::nan("") << 0.1 << 0.0 << out_of_domain << "outside";
  QTest::newRow("too near to the wall") << 4.8 << 1.0 << 0.1 << 0.5 << out_of_domain << "radius";
  QTest::newRow("no path") << 1.0 << 9.0 << 0.1 << 0.0 << static_cast<int>(ErrorCode::kDegenerate)
                           << "No path leads from (1.00, 1.00) to (9.00, 1.00)";
  QTest::newRow("no step") << 1.0 << 2.0 << 0.0 << 0.0 << out_of_domain << "step";
  QTest::newRow("tiny step") << 1.0 << 2.0 << 1e-9 << 0.0 << out_of_domain << "step";
  QTest::newRow("negative radius") << 1.0 << 2.0 << 0.1 << -1.0 << out_of_domain << "radius";
}

void GridPlannerTest::refusals() {
  QFETCH(double, start_x);
  QFETCH(double, goal_x);
  QFETCH(double, step);
  QFETCH(double, radius);
  QFETCH(int, code);
  QFETCH(QString, part);
  cv::Mat states(20, 100, CV_8UC1, cv::Scalar(kFree));
  states.col(50).setTo(kOccupied);
  states.col(70).setTo(kUnknown);
  const OccupancyGrid grid(*MapFrame::create(0.1, 100, 20, {}), states);
  PlannerSettings settings;
  settings.step_m = step;
  settings.robot_radius_m = radius;
  const Result<PlannedPath> path = planPath(grid, {start_x, 1.0}, {goal_x, 1.0}, settings);
  QVERIFY(!path);
  QCOMPARE(static_cast<int>(path.error().code), code);
  QVERIFY2(QString::fromStdString(path.error().message).contains(part), path.error().message.c_str());
}

QTEST_APPLESS_MAIN(GridPlannerTest)
#include "grid_planner_test.moc"
