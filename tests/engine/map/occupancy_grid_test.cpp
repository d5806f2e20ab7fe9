// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/map/occupancy_grid.h"

#include <opencv2/core.hpp>

#include <QtTest>

#include <limits>
#include <stdexcept>

using namespace cad2slam;

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

  void statesMustFitTheFrame() {
    const MapFrame frame = *MapFrame::create(1.0, 2, 3, Pose2{});
    QVERIFY_EXCEPTION_THROWN(OccupancyGrid(frame, cv::Mat(2, 3, CV_8UC1)), std::invalid_argument);
    QVERIFY_EXCEPTION_THROWN(OccupancyGrid(frame, cv::Mat(3, 2, CV_16UC1)), std::invalid_argument);
  }
};

QTEST_APPLESS_MAIN(OccupancyGridTest)
#include "occupancy_grid_test.moc"
