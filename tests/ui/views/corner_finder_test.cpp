// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/views/corner_finder.h"

#include <cmath>

#include <QTest>

#include "ui/support/rasters.h"

namespace cad2slam {
namespace {

class CornerFinderTest : public QObject {
  Q_OBJECT

 private slots:
  void findsTheCornerOfARoom_data() {
    QTest::addColumn<int>("level");
    for (int level = 0; level < 4; ++level) QTest::addRow("level %d", level) << level;
  }
  void findsTheCornerOfARoom() {
    QFETCH(int, level);
    cv::Mat pixels(1200, 1600, CV_8UC1, cv::Scalar(255));
    pixels(cv::Rect(640, 480, 320, 240)).setTo(0);
    const auto raster = TilePyramid::fromPixels(pixels);
    const double reach = 10.0 * (1 << level);
    for (const QPointF corner : {QPointF(640, 480), QPointF(960, 480), QPointF(640, 720), QPointF(960, 720)}) {
      for (const QPointF offset : {QPointF(0, 0), QPointF(5, -4), QPointF(-6, 3)}) {
        const auto found = findCorner(*raster, corner + offset * (1 << level), reach, level);
        QVERIFY(found.has_value());
        QVERIFY2(std::hypot(found->x() - corner.x(), found->y() - corner.y()) < 0.6,
                 qPrintable(QStringLiteral("%1 %2").arg(found->x()).arg(found->y())));
      }
    }
  }

  void findsCrossingsOfThinLines() {
    cv::Mat pixels(400, 400, CV_8UC1, cv::Scalar(255));
    pixels.col(200).setTo(0);
    pixels.row(150).setTo(0);
    const auto raster = TilePyramid::fromPixels(pixels);
    const auto found = findCorner(*raster, {203.0, 147.0}, 10.0, 0);
    QVERIFY(found.has_value());
    QVERIFY2(std::hypot(found->x() - 200.5, found->y() - 150.5) < 1.6,
             qPrintable(QStringLiteral("%1 %2").arg(found->x()).arg(found->y())));
  }

  void nothingOnStraightWallsAndFaintNoise() {
    cv::Mat pixels(400, 400, CV_8UC1, cv::Scalar(240));
    cv::Mat noise(pixels.size(), CV_8UC1);
    cv::theRNG().state = 5;
    cv::randn(noise, 4, 3);
    pixels += noise;
    pixels.colRange(180, 200).setTo(0);
    const auto raster = TilePyramid::fromPixels(pixels);
    QVERIFY(!findCorner(*raster, {190.0, 200.0}, 10.0, 0));
    QVERIFY(!findCorner(*raster, {300.0, 200.0}, 10.0, 0));
  }

  void stopsAtTheReachAndTheEdgeOfTheRaster() {
    cv::Mat pixels(200, 200, CV_8UC1, cv::Scalar(255));
    pixels(cv::Rect(50, 50, 60, 60)).setTo(0);
    const auto raster = TilePyramid::fromPixels(pixels);
    QVERIFY(!findCorner(*raster, {30.0, 30.0}, 10.0, 0));
    QVERIFY(!findCorner(*raster, {-500.0, 1e7}, 10.0, 0));
    QVERIFY(!findCorner(*raster, {std::nan(""), 3.0}, 10.0, 0));
    QVERIFY(!findCorner(*raster, {1.0, 1.0}, 10.0, 0));
  }
};

}  // namespace
}  // namespace cad2slam

QTEST_MAIN(cad2slam::CornerFinderTest)
#include "corner_finder_test.moc"
