// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/projection/overlay_picture.h"

#include <QtTest>

#include <opencv2/core.hpp>
#include <random>

#include "support/synthetic_buildings.h"

namespace cad2slam {
namespace {

using Eigen::Vector2d;

constexpr int kFree = static_cast<int>(CellState::kFree);
constexpr int kOccupied = static_cast<int>(CellState::kOccupied);
constexpr int kUnknown = static_cast<int>(CellState::kUnknown);

MapFrame frameOf(int width_px, int height_px, double resolution, const Pose2& origin = {}) {
  return *MapFrame::create(resolution, width_px, height_px, origin);
}

/// A room of 20 x 10 m with walls one pixel thick at its rim and across.
OccupancyGrid thinWalls(double resolution) {
  const MapFrame frame = frameOf(static_cast<int>(20.0 / resolution), static_cast<int>(10.0 / resolution), resolution);
  return testing::drawGrid(frame, [&](int column, int row) {
    const bool rim = column == 0 || row == 0 || column == frame.width() - 1 || row == frame.height() - 1;
    return !rim && column != frame.width() / 2;
  });
}

Projector projectorOver(int width, int height, const Pose2& slam_from_blueprint) {
  ProjectorData data;
  for (std::int32_t row = 0; row < height; ++row) {
    for (std::int32_t column = 0; column < width; ++column) {
      const Vector2d center(column + 0.5, row + 0.5);
      data.node_tile.push_back({column, row});
      data.node_blueprint.push_back(center);
      data.node_slam.push_back(slam_from_blueprint * Pose2{center, 0.0});
      data.node_stretch.emplace_back(0.0, 0.0);
    }
  }
  return *Projector::create(data);
}

int countOf(const OccupancyGrid& grid, int state) {
  return cv::countNonZero(grid.states() == state);
}

}  // namespace

class OverlayPictureTest : public QObject {
  Q_OBJECT
 private slots:
  void warpKeepsThinWalls();
  void warpIsUnknownBeyondTheMesh();
  void trinaryValuesAreMapServers();
  void overlayShowsWhoSeesAWall();
  void overlayIsNotLargerThanAsked();
};

void OverlayPictureTest::warpKeepsThinWalls() {
  // Walls of 2.5 cm drawn at 20 cm per pixel: without pooling most of them would fall between the samples.
  const OccupancyGrid blueprint = thinWalls(0.025);
  const Pose2 turn{{14.0, 2.0}, 0.3};
  const Projector projector = projectorOver(20, 10, turn);
  const OccupancyGrid warped = *warpGrid(projector, true, blueprint, frameOf(200, 150, 0.2, {{5.0, -2.0}, 0.0}));
  int seen = 0;
  int all = 0;
  for (double y = 0.5; y < 9.5; y += 0.05) {
    const Vector2d on_wall = turn * Vector2d(10.0125, y);
    ++all;
    bool occupied = false;
    for (const double dx : {-0.2, 0.0, 0.2}) {
      for (const double dy : {-0.2, 0.0, 0.2}) {
        occupied = occupied || warped.at(on_wall + Vector2d(dx, dy)) == CellState::kOccupied;
      }
    }
    seen += occupied ? 1 : 0;
  }
  QCOMPARE(seen, all);
}

void OverlayPictureTest::warpIsUnknownBeyondTheMesh() {
  const OccupancyGrid blueprint = thinWalls(0.1);
  const OccupancyGrid warped =
      *warpGrid(projectorOver(20, 10, {}), true, blueprint, frameOf(400, 300, 0.1, {{-10.0, -10.0}, 0.0}));
  QVERIFY(warped.at(Vector2d(-5.0, -5.0)) == CellState::kUnknown);
  QVERIFY(warped.at(Vector2d(25.0, 5.0)) == CellState::kUnknown);
  QVERIFY(warped.at(Vector2d(5.05, 5.05)) == CellState::kFree);
  // What the blueprint says inside the building is all there.
  QCOMPARE(countOf(warped, kFree), countOf(blueprint, kFree));
  QCOMPARE(countOf(warped, kOccupied), countOf(blueprint, kOccupied));
}

void OverlayPictureTest::trinaryValuesAreMapServers() {
  cv::Mat states(1, 3, CV_8UC1);
  for (int k = 0; k < 3; ++k) states.at<std::uint8_t>(0, k) = static_cast<std::uint8_t>(k);
  const cv::Mat picture = trinaryPicture({frameOf(3, 1, 0.1), states});
  QCOMPARE(picture.type(), CV_8UC1);
  QCOMPARE(int{picture.at<std::uint8_t>(0, kFree)}, 254);
  QCOMPARE(int{picture.at<std::uint8_t>(0, kOccupied)}, 0);
  QCOMPARE(int{picture.at<std::uint8_t>(0, kUnknown)}, 205);
}

void OverlayPictureTest::overlayShowsWhoSeesAWall() {
  // The same walls in both maps, but the robot saw one more and missed the one across.
  const OccupancyGrid blueprint = thinWalls(0.1);
  cv::Mat states = blueprint.states().clone();
  states(cv::Rect(100, 1, 1, 98)).setTo(cv::Scalar(kFree));
  states(cv::Rect(50, 1, 1, 98)).setTo(cv::Scalar(kOccupied));
  const OccupancyGrid slam(blueprint.frame(), states);
  const std::vector<OverlayAnchor> anchors{{{15.0, 5.0}, {15.0, 5.0}}};
  const Result<cv::Mat> picture = drawOverlay(projectorOver(20, 10, {}), blueprint, slam, anchors);
  QVERIFY(picture.has_value());
  QCOMPARE(picture->type(), CV_8UC3);
  QCOMPARE(picture->size(), states.size());
  const cv::Vec3b free = picture->at<cv::Vec3b>(30, 75);
  const cv::Vec3b both = picture->at<cv::Vec3b>(30, 0);
  const cv::Vec3b only_slam = picture->at<cv::Vec3b>(30, 50);
  const cv::Vec3b only_blueprint = picture->at<cv::Vec3b>(30, 100);
  QVERIFY(free == cv::Vec3b(255, 255, 255));
  for (int channel = 0; channel < 3; ++channel) QVERIFY(both[channel] < 80);
  QVERIFY(only_slam[1] > 200 && only_slam[0] < 80 && only_slam[2] < 80);                  // green
  QVERIFY(only_blueprint[1] < 80 && only_blueprint[0] > 200 && only_blueprint[2] > 200);  // magenta
  bool ring = false;
  for (int column = 140; column < 160; ++column) ring = ring || picture->at<cv::Vec3b>(50, column) != free;
  QVERIFY(ring);
}

void OverlayPictureTest::overlayIsNotLargerThanAsked() {
  const OccupancyGrid blueprint = thinWalls(0.02);
  const Result<cv::Mat> picture = drawOverlay(projectorOver(20, 10, {}), blueprint, blueprint, {}, 300);
  QVERIFY(picture.has_value());
  QVERIFY(std::max(picture->cols, picture->rows) <= 300);
  QVERIFY(picture->cols >= 200);
}

}  // namespace cad2slam

QTEST_GUILESS_MAIN(cad2slam::OverlayPictureTest)
#include "overlay_picture_test.moc"
