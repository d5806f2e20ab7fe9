// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/services/ground_probe.h"

#include <QTest>

#include <cmath>
#include <limits>

#include <opencv2/imgproc.hpp>

#include "ui/services/tile_pyramid.h"

namespace cad2slam {
namespace {

constexpr int kWidth_px = 600;
constexpr int kHeight_px = 400;

/// Unknown all over, but for a room with walls in columns and rows 300 to 350.
cv::Mat roomInTheDark(int unknown, int free, int wall) {
  cv::Mat picture(kHeight_px, kWidth_px, CV_8UC1, cv::Scalar(unknown));
  cv::rectangle(picture, cv::Rect(300, 300, 51, 51), cv::Scalar(wall), cv::FILLED);
  cv::rectangle(picture, cv::Rect(302, 302, 47, 47), cv::Scalar(free), cv::FILLED);
  return picture;
}

class GroundProbeTest : public QObject {
  Q_OBJECT

 private slots:
  void tellsKnownUnknownAndOutside_data() {
    QTest::addColumn<bool>("negate");
    QTest::addColumn<double>("heading");
    for (const bool negate : {false, true})
      for (const double heading : {0.0, 0.7})
        QTest::addRow("negate %d, turned %g", negate, heading) << negate << heading;
  }
  void tellsKnownUnknownAndOutside() {
    QFETCH(bool, negate);
    QFETCH(double, heading);
    const cv::Mat picture = negate ? roomInTheDark(127, 0, 255) : roomInTheDark(127, 255, 0);
    const MapFrame frame = *MapFrame::create(0.05, kWidth_px, kHeight_px, {{-3.0, 8.0}, heading});
    MapMetadata metadata;
    metadata.negate = negate;
    const auto pyramid = TilePyramid::fromPixels(picture);
    GroundProbe probe(pyramid->store(), frame, metadata);
    const auto at = [&](double column, double row) { return probe.at(frame.metricFromPixel({column, row})); };
    for (int again = 0; again < 2; ++again) {
      QVERIFY(at(325.5, 325.5) == Ground::kKnown);  // floor
      QVERIFY(at(300.5, 325.5) == Ground::kKnown);  // wall
      QVERIFY(at(297.5, 325.5) == Ground::kKnown);  // its far side, within reach
      QVERIFY(at(290.5, 325.5) == Ground::kUnknown);
      QVERIFY(at(2.5, 2.5) == Ground::kUnknown);  // at a corner of the image
      QVERIFY(at(597.5, 397.5) == Ground::kUnknown);
      QVERIFY(at(-1.5, 200.0) == Ground::kOutsideImage);
      QVERIFY(at(300.0, 401.5) == Ground::kOutsideImage);
    }
    QVERIFY(probe.at({std::nan(""), 0.0}) == Ground::kOutsideImage);
    QVERIFY(probe.at({std::numeric_limits<double>::infinity(), 0.0}) == Ground::kOutsideImage);
  }

  void knowsWhoseItIs() {
    const auto pyramid = TilePyramid::fromPixels(roomInTheDark(127, 255, 0));
    const auto other = TilePyramid::fromPixels(roomInTheDark(127, 255, 0));
    const MapFrame frame = *MapFrame::create(0.05, kWidth_px, kHeight_px, {{-3.0, 8.0}, 0.2});
    const GroundProbe probe(pyramid->store(), frame, {});
    QVERIFY(probe.isOf(pyramid->store(), frame));
    QVERIFY(!probe.isOf(other->store(), frame));
    QVERIFY(!probe.isOf(pyramid->store(), *MapFrame::create(0.06, kWidth_px, kHeight_px, {{-3.0, 8.0}, 0.2})));
    QVERIFY(!probe.isOf(pyramid->store(), *MapFrame::create(0.05, kWidth_px, kHeight_px, {{-3.0, 8.0}, 0.3})));
  }
};

}  // namespace
}  // namespace cad2slam

QTEST_MAIN(cad2slam::GroundProbeTest)
#include "ground_probe_test.moc"
