// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/evaluation/report_pictures.h"

#include <opencv2/core.hpp>

#include <QtTest>

#include <limits>

using namespace cad2slam;

namespace {

OccupancyGrid makeMap(int width, int height) {
  cv::Mat states(height, width, CV_8UC1, cv::Scalar(static_cast<int>(CellState::kFree)));
  states.row(0).setTo(static_cast<int>(CellState::kOccupied));
  return {*MapFrame::create(0.1, width, height, {{5.0, 5.0}, 0.0}), states};
}

}  // namespace

class ReportPicturesTest : public QObject {
  Q_OBJECT
 private slots:
  void valuesAreDrawnWhereTheyAre() {
    const OccupancyGrid map = makeMap(300, 200);
    const auto picture = drawValueMap(map, {{{10.0, 10.0}, 0.0}, {{30.0, 20.0}, 1.0}, {{25.0, 8.0}, 1.0}}, 1.0, "m");
    QVERIFY(picture);
    const auto color = [&](double x, double y) {
      const Eigen::Vector2d pixel = map.frame().pixelFromMetric({x, y});
      return picture->at<cv::Vec3b>(static_cast<int>(pixel.y()), static_cast<int>(pixel.x()));
    };
    QVERIFY(color(30.0, 20.0) == color(25.0, 8.0));
    QVERIFY(color(10.0, 10.0) != color(30.0, 20.0));
    QVERIFY((color(15.0, 20.0) == cv::Vec3b(255, 255, 255)));
    QVERIFY((picture->at<cv::Vec3b>(0, 50) == cv::Vec3b(60, 60, 60)));  // the wall
  }

  void largeMapsAreMadeSmall() {
    const auto picture = drawValueMap(makeMap(5000, 300), {}, 1.0, "m", 1000);
    QVERIFY(picture);
    QVERIFY(picture->cols <= 1000 && picture->cols > 700);
  }

  void waysAreColouredByTheirValues() {
    const OccupancyGrid map = makeMap(300, 200);
    const auto plain = drawWays(map, {}, "m");
    const auto ways = drawWays(map, {{{{6.0, 10.0}, 0.1}, {{30.0, 10.0}, 0.2}}, {}}, "m");
    QVERIFY(plain && ways);
    QVERIFY(cv::norm(*plain, *ways, cv::NORM_L1) > 0.0);
  }

  void brokenNumbersDoNoHarm() {
    const double infinity = std::numeric_limits<double>::infinity();
    QVERIFY(drawValueMap(makeMap(30, 20), {{{1e300, -1e300}, infinity}, {{6.0, 6.0}, std::nan("")}}, 0.1, "m"));
    QVERIFY(drawWays(makeMap(30, 20), {{{{6.0, 6.0}, infinity}, {{7.0, 6.0}, 1.0}}}, "m"));
  }
};

QTEST_APPLESS_MAIN(ReportPicturesTest)
#include "report_pictures_test.moc"
