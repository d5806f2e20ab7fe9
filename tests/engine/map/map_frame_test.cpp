// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/map/map_frame.h"

#include <QtTest>

#include <limits>
#include <random>

using namespace cad2slam;
using Eigen::Vector2d;

class MapFrameTest : public QObject {
  Q_OBJECT

 private slots:
  void cornersLieWhereMapServerPutsThem() {
    const MapFrame frame = *MapFrame::create(0.05, 200, 100, Pose2{{-1.0, -2.0}, 0.0});
    QVERIFY((frame.metricFromPixel({0.0, 100.0}) - Vector2d(-1.0, -2.0)).norm() < 1e-12);  // outer bottom left
    QVERIFY((frame.metricFromPixel({200.0, 0.0}) - Vector2d(9.0, 3.0)).norm() < 1e-12);    // outer top right
    QVERIFY((frame.metricFromPixel({0.5, 99.5}) - Vector2d(-0.975, -1.975)).norm() < 1e-12);
  }

  void yawTurnsAboutTheCorner() {
    const MapFrame frame = *MapFrame::create(1.0, 10, 10, Pose2{{5.0, 6.0}, kPi / 2.0});
    QVERIFY((frame.metricFromPixel({0.0, 10.0}) - Vector2d(5.0, 6.0)).norm() < 1e-12);
    QVERIFY((frame.metricFromPixel({1.0, 10.0}) - Vector2d(5.0, 7.0)).norm() < 1e-12);  // image right is metric up
    QVERIFY((frame.metricFromPixel({0.0, 9.0}) - Vector2d(4.0, 6.0)).norm() < 1e-12);   // image up is metric left
  }

  void pixelsAndMetresAreInverse() {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    for (int k = 0; k < 1000; ++k) {
      const MapFrame frame = *MapFrame::create(std::exp(3.0 * unit(random)), 1 + k, 1 + 3 * k,
                                               Pose2{{100.0 * unit(random), 100.0 * unit(random)}, 4.0 * unit(random)});
      const Vector2d pixel(1e4 * unit(random), 1e4 * unit(random));
      QVERIFY((frame.pixelFromMetric(frame.metricFromPixel(pixel)) - pixel).norm() < 1e-7);
    }
  }

  void insideIsHalfOpen() {
    const MapFrame frame = *MapFrame::create(0.5, 4, 2, Pose2{});
    QVERIFY(frame.contains(frame.metricFromPixel({0.0, 0.0})));
    QVERIFY(frame.contains(frame.metricFromPixel({3.999, 1.999})));
    QVERIFY(!frame.contains(frame.metricFromPixel({4.0, 1.0})));
    QVERIFY(!frame.contains(frame.metricFromPixel({1.0, 2.0})));
    QVERIFY(!frame.contains({std::numeric_limits<double>::quiet_NaN(), 0.5}));
  }

  void refusesWhatIsNoFrame_data() {
    QTest::addColumn<double>("resolution");
    QTest::addColumn<int>("width");
    QTest::addColumn<int>("height");
    QTest::addColumn<double>("yaw");
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    QTest::newRow("zero resolution") << 0.0 << 1 << 1 << 0.0;
    QTest::newRow("negative resolution") << -0.05 << 1 << 1 << 0.0;
    QTest::newRow("NaN resolution") << nan << 1 << 1 << 0.0;
    QTest::newRow("infinite resolution") << infinity << 1 << 1 << 0.0;
    QTest::newRow("no width") << 0.05 << 0 << 1 << 0.0;
    QTest::newRow("negative height") << 0.05 << 1 << -1 << 0.0;
    QTest::newRow("NaN yaw") << 0.05 << 1 << 1 << nan;
  }
  void refusesWhatIsNoFrame() {
    QFETCH(double, resolution);
    QFETCH(int, width);
    QFETCH(int, height);
    QFETCH(double, yaw);
    const Result<MapFrame> frame = MapFrame::create(resolution, width, height, Pose2{{0.0, 0.0}, yaw});
    QVERIFY(!frame);
    QVERIFY(frame.error().code == ErrorCode::kMalformed);
    QVERIFY(!frame.error().message.empty());
  }
};

QTEST_APPLESS_MAIN(MapFrameTest)
#include "map_frame_test.moc"
