// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/exports/zone_mask.h"

#include <QtTest>

#include <opencv2/core.hpp>

#include <random>

namespace cad2slam {
namespace {

using Eigen::Vector2d;

double distanceToSegment(const Vector2d& place, const Vector2d& a, const Vector2d& b) {
  const Vector2d along = b - a;
  const double squared = along.squaredNorm();
  const double part = squared > 0.0 ? std::clamp((place - a).dot(along) / squared, 0.0, 1.0) : 0.0;
  return (place - a - part * along).norm();
}

/// Whether a ring goes around a place at all, by the angle it turns through.
bool goesAround(const PointList& ring, const Vector2d& place) {
  double turned = 0.0;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Vector2d a = ring[k] - place;
    const Vector2d b = ring[(k + 1) % ring.size()] - place;
    turned += std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
  }
  return std::abs(turned) > 1.0;
}

double distanceToBorder(const std::vector<PointList>& rings, const Vector2d& place) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const PointList& ring : rings) {
    for (std::size_t k = 0; k < ring.size(); ++k) {
      nearest = std::min(nearest, distanceToSegment(place, ring[k], ring[(k + 1) % ring.size()]));
    }
  }
  return nearest;
}

bool isOnZone(const MaskZone& zone, const Vector2d& place) {
  if (!goesAround(zone.rings.front(), place)) return false;
  return std::none_of(zone.rings.begin() + 1, zone.rings.end(),
                      [&](const PointList& hole) { return goesAround(hole, place); });
}

/// A star-shaped ring around a centre.
PointList randomRing(std::mt19937& random, const Vector2d& center, double least, double most) {
  std::uniform_real_distribution<double> radius(least, most);
  PointList ring;
  for (int k = 0; k < 9; ++k) {
    const double angle = 2.0 * 3.14159265358979 * k / 9;
    ring.push_back(center + radius(random) * Vector2d(std::cos(angle), std::sin(angle)));
  }
  return ring;
}

MapFrame smallFrame() {
  return *MapFrame::create(0.1, 60, 50, {{-1.0, 2.0}, 0.0});
}

std::uint8_t pixelAt(const cv::Mat& mask, const MapFrame& frame, const Vector2d& place) {
  const Vector2d pixel = frame.pixelFromMetric(place);
  return mask.at<std::uint8_t>(static_cast<int>(pixel.y()), static_cast<int>(pixel.x()));
}

}  // namespace

class ZoneMaskTest : public QObject {
  Q_OBJECT
 private slots:
  void leavesNothingOutAndTakesLittleMore();
  void coveredPixelsAreWhollyInside();
  void edgesOnPixelBordersTouchBothSides();
  void zonesBesideTheMapReachIn();
  void aRingThatCrossesItselfIsAllZone();
  void overlappingSpeedZonesAreSlow();
  void refusesWhatIsNoZone();
};

void ZoneMaskTest::leavesNothingOutAndTakesLittleMore() {
  const MapFrame frame = smallFrame();
  std::mt19937 random(1);
  std::uniform_real_distribution<double> x(-1.5, 5.5);
  std::uniform_real_distribution<double> y(1.5, 7.5);
  for (int round = 0; round < 30; ++round) {
    MaskZone zone;
    const Vector2d center(x(random), y(random));
    zone.rings = {randomRing(random, center, 0.8, 2.5), randomRing(random, center, 0.2, 0.7)};
    zone.buffer_m = round % 3 == 0 ? 0.0 : 0.07 * (round % 7);
    const Result<cv::Mat> touched = touchedPixels(frame, zone);
    QVERIFY(touched.has_value());
    std::uniform_real_distribution<double> column(0.0, frame.width());
    std::uniform_real_distribution<double> row(0.0, frame.height());
    for (int k = 0; k < 4000; ++k) {
      const Vector2d place = frame.metricFromPixel({column(random), row(random)});
      const double border = distanceToBorder(zone.rings, place);
      const bool inside = isOnZone(zone, place);
      if (inside || border <= zone.buffer_m) QVERIFY(pixelAt(*touched, frame, place) == 255);
      if (!inside && border > zone.buffer_m + (1.7 + 1.5) * frame.resolution()) {
        QVERIFY(pixelAt(*touched, frame, place) == 0);
      }
    }
  }
}

void ZoneMaskTest::coveredPixelsAreWhollyInside() {
  const MapFrame frame = smallFrame();
  std::mt19937 random(2);
  for (int round = 0; round < 10; ++round) {
    MaskZone zone;
    zone.rings = {randomRing(random, {2.0, 4.5}, 1.0, 2.0), randomRing(random, {2.0, 4.5}, 0.1, 0.5)};
    zone.buffer_m = 0.1 * round / 3;
    const Result<cv::Mat> covered = coveredPixels(frame, zone);
    QVERIFY(covered.has_value());
    for (int row = 0; row < frame.height(); ++row) {
      for (int column = 0; column < frame.width(); ++column) {
        if (covered->at<std::uint8_t>(row, column) == 0) continue;
        for (const Vector2d& corner : {Vector2d(0, 0), Vector2d(1, 0), Vector2d(0, 1), Vector2d(1, 1)}) {
          const Vector2d place = frame.metricFromPixel(Vector2d(column, row) + corner);
          QVERIFY(isOnZone(zone, place) && distanceToBorder(zone.rings, place) >= zone.buffer_m);
        }
      }
    }
  }
  MaskZone lane;
  lane.lines = {{{0.0, 4.0}, {3.0, 5.0}}};
  lane.buffer_m = 0.4;
  const Result<cv::Mat> covered = coveredPixels(frame, lane);
  QVERIFY(cv::countNonZero(*covered) > 50);
  for (int row = 0; row < frame.height(); ++row) {
    for (int column = 0; column < frame.width(); ++column) {
      if (covered->at<std::uint8_t>(row, column) == 0) continue;
      for (const Vector2d& corner : {Vector2d(0, 0), Vector2d(1, 0), Vector2d(0, 1), Vector2d(1, 1)}) {
        const Vector2d place = frame.metricFromPixel(Vector2d(column, row) + corner);
        QVERIFY(distanceToSegment(place, lane.lines[0][0], lane.lines[0][1]) <= 0.4);
      }
    }
  }
}

void ZoneMaskTest::edgesOnPixelBordersTouchBothSides() {
  const MapFrame frame = *MapFrame::create(1.0, 8, 8, {});
  MaskZone zone;
  zone.rings = {{{2.0, 2.0}, {5.0, 2.0}, {5.0, 5.0}, {2.0, 5.0}}};
  const cv::Mat touched = *touchedPixels(frame, zone);
  QCOMPARE(cv::countNonZero(touched), 25);  // 3 x 3 inside and the ring of those that only share a border
  QCOMPARE(cv::countNonZero(*coveredPixels(frame, zone)), 1);
}

void ZoneMaskTest::zonesBesideTheMapReachIn() {
  const MapFrame frame = *MapFrame::create(1.0, 8, 8, {});
  MaskZone zone;
  zone.rings = {{{-9.0, 0.0}, {-2.0, 0.0}, {-2.0, 8.0}, {-9.0, 8.0}}};
  QCOMPARE(cv::countNonZero(*touchedPixels(frame, zone)), 0);
  zone.buffer_m = 3.0;
  const cv::Mat touched = *touchedPixels(frame, zone);
  for (int row = 0; row < 8; ++row) QCOMPARE(int{touched.at<std::uint8_t>(row, 0)}, 255);
  zone.rings = {{{-1e12, -1e12}, {1e12, -1e12}, {1e12, 1e12}, {-1e12, 1e12}}};
  QCOMPARE(cv::countNonZero(*touchedPixels(frame, zone)), 64);
}

void ZoneMaskTest::aRingThatCrossesItselfIsAllZone() {
  const MapFrame frame = *MapFrame::create(1.0, 20, 20, {});
  MaskZone zone;  // the middle is gone around twice
  zone.rings = {{{1, 1}, {18, 1}, {18, 18}, {1, 18}, {1, 1}, {6, 6}, {12, 6}, {12, 12}, {6, 12}, {6, 6}}};
  QCOMPARE(int{pixelAt(*touchedPixels(frame, zone), frame, {9.5, 9.5})}, 255);
  QCOMPARE(int{pixelAt(*coveredPixels(frame, zone), frame, {9.5, 9.5})}, 0);
}

void ZoneMaskTest::overlappingSpeedZonesAreSlow() {
  const MapFrame frame = *MapFrame::create(1.0, 10, 10, {});
  const auto square = [](double from, double to) {
    MaskZone zone;
    zone.rings = {{{from, from}, {to, from}, {to, to}, {from, to}}};
    return zone;
  };
  for (const bool slow_first : {false, true}) {
    std::vector<SpeedZone> zones = {{square(0.5, 8.5), 80.0}, {square(3.2, 6.2), 30.0}};
    if (slow_first) std::swap(zones[0], zones[1]);
    const cv::Mat mask = *speedMask(frame, zones);
    QCOMPARE(pixelAt(mask, frame, {4.5, 4.5}), greyOfPercent(30.0));
    QCOMPARE(pixelAt(mask, frame, {1.5, 1.5}), greyOfPercent(80.0));
    QCOMPARE(pixelAt(mask, frame, {9.5, 9.5}), greyOfPercent(0.0));
  }
  for (int percent = 0; percent <= 100; ++percent) {
    const double occupancy = (255 - greyOfPercent(percent)) / 255.0;
    QCOMPARE(static_cast<int>(std::lround(100.0 * occupancy)), percent);
  }
}

void ZoneMaskTest::refusesWhatIsNoZone() {
  const MapFrame frame = smallFrame();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  MaskZone zone;
  zone.rings = {{{0, 0}, {1, 0}, {nan, 1}}};
  QVERIFY(!touchedPixels(frame, zone).has_value());
  zone.rings.clear();
  for (const double buffer : {-0.1, nan, 1e9}) {
    zone.buffer_m = buffer;
    QVERIFY(!touchedPixels(frame, zone).has_value());
    QVERIFY(!coveredPixels(frame, zone).has_value());
  }
  QVERIFY(!speedMask(frame, {{{}, 0.0}}).has_value());
  QVERIFY(!speedMask(frame, {{{}, nan}}).has_value());
}

}  // namespace cad2slam

QTEST_GUILESS_MAIN(cad2slam::ZoneMaskTest)
#include "zone_mask_test.moc"
