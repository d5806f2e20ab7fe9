// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/simulation/site_plan.h"

#include "cad2slam/simulation/site_generator.h"

#include <opencv2/imgproc.hpp>

#include <QtTest>

#include <cmath>

using namespace cad2slam;

class SitePlanTest : public QObject {
  Q_OBJECT
 private slots:
  void everyRoomCanBeReached_data();
  void everyRoomCanBeReached();
  void cornersAreCorners();
  void boxesFillThePixelsTheyHold();
};

void SitePlanTest::everyRoomCanBeReached_data() {
  QTest::addColumn<int>("kind");
  QTest::addColumn<int>("shape");
  QTest::addColumn<double>("width");
  QTest::addColumn<double>("height");
  const auto row = [](const char* name, SiteKind kind, CorridorShape shape, double width, double height) {
    QTest::newRow(name) << static_cast<int>(kind) << static_cast<int>(shape) << width << height;
  };
  row("flat", SiteKind::kFlat, CorridorShape::kU, 11, 8);
  row("small office", SiteKind::kOffice, CorridorShape::kU, 20, 12);
  row("large office", SiteKind::kOffice, CorridorShape::kU, 90, 58);
  row("straight corridor", SiteKind::kCorridor, CorridorShape::kStraight, 100, 15);
  row("L", SiteKind::kCorridor, CorridorShape::kL, 50, 30);
  row("U", SiteKind::kCorridor, CorridorShape::kU, 80, 40);
  row("ring", SiteKind::kCorridor, CorridorShape::kRing, 60, 45);
  row("hall", SiteKind::kHall, CorridorShape::kU, 60, 40);
}

void SitePlanTest::everyRoomCanBeReached() {
  QFETCH(int, kind);
  QFETCH(int, shape);
  QFETCH(double, width);
  QFETCH(double, height);
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    BuildingRecipe recipe;
    recipe.plan = {static_cast<SiteKind>(kind), {width, height}, static_cast<CorridorShape>(shape)};
    recipe.seed = seed;
    const Result<Building> building = makeBuilding(recipe);
    QVERIFY(building);
    QVERIFY(building->plan.route.size() >= 2);
    const cv::Mat is_free = building->blueprint.states() == static_cast<int>(CellState::kFree);
    cv::Mat labels;
    QCOMPARE(cv::connectedComponents(is_free, labels, 4), 2);  // the background and one building
    for (const Eigen::Vector2d& place : building->plan.route) QVERIFY(building->plan.isFree(place));
  }
}

void SitePlanTest::cornersAreCorners() {
  SeededRandom random(9);
  const SitePlan plan = makeSitePlan({SiteKind::kOffice, {40.0, 24.0}, CorridorShape::kU}, random);
  const std::vector<Eigen::Vector2d> corners = plan.corners();
  QVERIFY(corners.size() > 60);
  for (const Eigen::Vector2d& corner : corners) {
    int free_around = 0;
    for (int i = 0; i < 360; ++i) {
      const double direction = i * kPi / 180.0 + 0.001;
      free_around += plan.isFree(corner + 0.02 * Eigen::Vector2d(std::cos(direction), std::sin(direction))) ? 1 : 0;
    }
    QVERIFY(std::abs(free_around - 90) < 3 || std::abs(free_around - 270) < 3);
  }
}

void SitePlanTest::boxesFillThePixelsTheyHold() {
  const MapFrame frame = *MapFrame::create(0.1, 100, 80, {{-1.0, -2.0}, 0.0});
  const Similarity2 frame_from_plan{1.5, 0.6, {3.0, 0.5}};
  const Box box{{0.2, 0.3}, {1.7, 1.1}};
  cv::Mat states(80, 100, CV_8UC1, cv::Scalar(static_cast<int>(CellState::kUnknown)));
  fillBox(states, frame, frame_from_plan, box, CellState::kFree);
  int filled = 0;
  for (int row = 0; row < 80; ++row) {
    for (int column = 0; column < 100; ++column) {
      const Eigen::Vector2d place = frame_from_plan.inverse() * frame.metricFromPixel({column + 0.5, row + 0.5});
      const bool is_free = states.at<std::uint8_t>(row, column) == static_cast<std::uint8_t>(CellState::kFree);
      QCOMPARE(is_free, box.contains(place));
      filled += is_free ? 1 : 0;
    }
  }
  QVERIFY(std::abs(filled * 0.01 - box.size().prod() * 1.5 * 1.5) < 0.1);
}

QTEST_APPLESS_MAIN(SitePlanTest)
#include "site_plan_test.moc"
