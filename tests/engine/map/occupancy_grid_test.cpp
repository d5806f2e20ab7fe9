// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/map/occupancy_grid.h"

#include <opencv2/core.hpp>

#include <QtTest>

#include <algorithm>
#include <limits>
#include <random>
#include <stdexcept>
#include <utility>

using namespace cad2slam;

namespace {

constexpr int kFree = static_cast<int>(CellState::kFree);
constexpr int kOccupied = static_cast<int>(CellState::kOccupied);
constexpr int kUnknown = static_cast<int>(CellState::kUnknown);

/// Mostly one state for each patch of 30 x 40 pixels, with single pixels of others.
cv::Mat patchwork(int width, int height) {
  std::mt19937 random(5);
  cv::Mat states(height, width, CV_8UC1);
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      const int patch = (row / 30 * 7 + column / 40 * 3) % 3;
      const bool is_odd_one = patch == 2 && random() % 50 == 0;
      states.at<std::uint8_t>(row, column) = static_cast<std::uint8_t>(is_odd_one ? random() % 3 : patch);
    }
  }
  return states;
}

bool same(const cv::Mat& a, const cv::Mat& b) {
  return a.size() == b.size() && a.type() == b.type() && cv::norm(a, b, cv::NORM_INF) == 0.0;
}

}  // namespace

class OccupancyGridTest : public QObject {
  Q_OBJECT

 private slots:
  void pointsReadThePixelTheyLieOn() {
    cv::Mat states(3, 4, CV_8UC1, cv::Scalar(static_cast<int>(CellState::kUnknown)));
    states.at<std::uint8_t>(0, 1) = static_cast<std::uint8_t>(CellState::kOccupied);
    states.at<std::uint8_t>(2, 3) = static_cast<std::uint8_t>(CellState::kFree);
    const OccupancyGrid grid(*MapFrame::create(0.5, 4, 3, Pose2{{10.0, 20.0}, 0.3}), states);
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 4; ++column) {
        const Eigen::Vector2d center = grid.frame().metricFromPixel({column + 0.5, row + 0.5});
        QVERIFY(grid.at(center) == grid.at(column, row));
      }
    }
    QVERIFY(grid.at(1, 0) == CellState::kOccupied);
    QVERIFY(grid.at(3, 2) == CellState::kFree);
  }

  void outsideIsUnknown() {
    const cv::Mat states(2, 2, CV_8UC1, cv::Scalar(0));
    const OccupancyGrid grid(*MapFrame::create(1.0, 2, 2, Pose2{}), states);
    QVERIFY(grid.at(1, 1) == CellState::kFree);
    QVERIFY(grid.at(2, 0) == CellState::kUnknown);
    QVERIFY(grid.at(0, -1) == CellState::kUnknown);
    for (const double far : {-1e-9, 2.0 + 1e-9, 1e300, -1e300, std::numeric_limits<double>::infinity(),
                             std::numeric_limits<double>::quiet_NaN()}) {
      QVERIFY(grid.at(Eigen::Vector2d(far, 1.0)) == CellState::kUnknown);
      QVERIFY(grid.at(Eigen::Vector2d(1.0, far)) == CellState::kUnknown);
    }
  }

  void pixelsAreKept_data() {
    QTest::addColumn<int>("width");
    QTest::addColumn<int>("height");
    for (const auto& [width, height] : {std::pair(1, 1), {64, 64}, {65, 63}, {200, 129}, {31, 640}, {777, 345}})
      QTest::addRow("%d x %d", width, height) << width << height;
  }
  void pixelsAreKept() {
    QFETCH(int, width);
    QFETCH(int, height);
    const cv::Mat states = patchwork(width, height);
    const OccupancyGrid grid(*MapFrame::create(0.05, width, height, {}), states);
    QVERIFY(same(grid.states(), states));
    QCOMPARE(grid.freePixels(), static_cast<std::size_t>(cv::countNonZero(states == kFree)));
    std::mt19937 random(3);
    const auto below = [&random](int limit) { return static_cast<int>(random() % static_cast<unsigned>(limit)); };
    for (int k = 0; k < 300; ++k) {
      const int x = below(width);
      const int y = below(height);
      QCOMPARE(static_cast<int>(grid.at(x, y)), int{states.at<std::uint8_t>(y, x)});
      const cv::Rect piece(x, y, 1 + below(width - x), 1 + below(height - y));
      QVERIFY(same(grid.states(piece), states(piece)));
      QCOMPARE(grid.holdsFree(piece), cv::countNonZero(states(piece) == kFree) > 0);
    }
  }

  void oneFreePixelIsFoundWhereverItLies() {
    for (const int at : {0, 31, 32, 63, 64, 99}) {
      cv::Mat states(100, 100, CV_8UC1, cv::Scalar(kOccupied));
      states.at<std::uint8_t>(at, 99 - at) = static_cast<std::uint8_t>(kFree);
      const OccupancyGrid grid(*MapFrame::create(1.0, 100, 100, {}), states);
      QVERIFY(grid.holdsFree({0, 0, 100, 100}));
      QVERIFY(grid.holdsFree({99 - at, at, 1, 1}));
      QVERIFY(at == 0 || !grid.holdsFree({0, 0, 100, at}));
      QVERIFY(at == 99 || !grid.holdsFree({0, at + 1, 100, 99 - at}));
    }
  }

  void rowsMayComeInAnyPieces() {
    const cv::Mat states = patchwork(150, 301);
    const MapFrame frame = *MapFrame::create(0.05, 150, 301, {});
    for (const int step : {1, 7, 63, 64, 65, 128, 301}) {
      OccupancyGridBuilder builder(frame);
      for (int row = 0; row < states.rows; row += step)
        builder.append(states.rowRange(row, std::min(states.rows, row + step)));
      const OccupancyGrid grid = builder.build();
      QVERIFY(same(grid.states(), states));
      QCOMPARE(grid.freePixels(), OccupancyGrid(frame, states).freePixels());
    }
  }

  void rowsThatNeverCameAreUnknown() {
    OccupancyGridBuilder builder(*MapFrame::create(0.05, 20, 200, {}));
    builder.append(cv::Mat(70, 20, CV_8UC1, cv::Scalar(kFree)));
    const OccupancyGrid grid = builder.build();
    QCOMPARE(grid.freePixels(), std::size_t{70 * 20});
    QVERIFY(grid.at(19, 69) == CellState::kFree && grid.at(0, 70) == CellState::kUnknown);
    QVERIFY(grid.at(19, 199) == CellState::kUnknown);
  }

  void emptySpaceTakesHardlyAnyMemory() {
    const OccupancyGrid plain(*MapFrame::create(0.05, 6400, 6400, {}), cv::Mat(6400, 6400, CV_8UC1, cv::Scalar(0)));
    QCOMPARE(plain.memory(), std::size_t{4 * 100 * 100});
    QVERIFY(plain.withFrame(*MapFrame::create(0.1, 6400, 6400, {})).frame().resolution() == 0.1);
    cv::Mat noise(640, 640, CV_8UC1);
    cv::randu(noise, 0, 3);
    const OccupancyGrid mixed(*MapFrame::create(0.05, 640, 640, {}), noise);
    QVERIFY(mixed.memory() <= 640 * 640 / 4 + 4 * 100);
  }

  void poolingLosesNoWall_data() {
    QTest::addColumn<int>("factor");
    for (const int factor : {1, 2, 3, 7, 64, 1000}) QTest::addRow("by %d", factor) << factor;
  }
  void poolingLosesNoWall() {
    QFETCH(int, factor);
    std::mt19937 random(1);
    cv::Mat states(53, 91, CV_8UC1);
    for (int row = 0; row < states.rows; ++row) {
      for (int column = 0; column < states.cols; ++column) {
        const auto part = random() % 100;
        const int state = part < 2 ? kOccupied : part < 6 ? kUnknown : kFree;
        states.at<std::uint8_t>(row, column) = static_cast<std::uint8_t>(state);
      }
    }
    const OccupancyGrid grid(*MapFrame::create(0.05, 91, 53, {}), states);
    const Result<OccupancyGrid> result = pooled(grid, factor);
    QVERIFY(result.has_value());
    QCOMPARE(result->frame().width(), (91 + factor - 1) / factor);
    QCOMPARE(result->frame().height(), (53 + factor - 1) / factor);
    for (int row = 0; row < result->frame().height(); ++row) {
      for (int column = 0; column < result->frame().width(); ++column) {
        int expected = kFree;
        for (int y = row * factor; y < std::min(53, (row + 1) * factor); ++y) {
          for (int x = column * factor; x < std::min(91, (column + 1) * factor); ++x) {
            const int state = states.at<std::uint8_t>(y, x);
            if (state == kOccupied || (state == kUnknown && expected == kFree)) expected = state;
          }
        }
        QCOMPARE(static_cast<int>(result->at(column, row)), expected);
      }
    }
  }

  void pooledPlacesStayInPlace() {
    const MapFrame frame = *MapFrame::create(0.05, 91, 53, {{3.0, -7.0}, 0.4});
    cv::Mat states(53, 91, CV_8UC1, cv::Scalar(kFree));
    states.at<std::uint8_t>(17, 44) = static_cast<std::uint8_t>(kOccupied);
    const OccupancyGrid result = *pooled({frame, states}, 5);
    QVERIFY(result.at(frame.metricFromPixel({44.5, 17.5})) == CellState::kOccupied);
    QCOMPARE(cv::countNonZero(result.states() == kOccupied), 1);
  }

  void statesMustFitTheFrame() {
    const MapFrame frame = *MapFrame::create(1.0, 2, 3, Pose2{});
    QVERIFY_EXCEPTION_THROWN(OccupancyGrid(frame, cv::Mat(2, 3, CV_8UC1)), std::invalid_argument);
    QVERIFY_EXCEPTION_THROWN(OccupancyGrid(frame, cv::Mat(3, 2, CV_16UC1)), std::invalid_argument);
    OccupancyGridBuilder builder(frame);
    QVERIFY_EXCEPTION_THROWN(builder.append(cv::Mat(1, 3, CV_8UC1)), std::invalid_argument);
    QVERIFY_EXCEPTION_THROWN(builder.append(cv::Mat(4, 2, CV_8UC1)), std::invalid_argument);
  }
};

QTEST_APPLESS_MAIN(OccupancyGridTest)
#include "occupancy_grid_test.moc"
