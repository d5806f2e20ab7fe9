// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/document/room_map.h"

#include <QTest>

#include <limits>
#include <set>

using namespace cad2slam;

namespace {

constexpr int kFree = static_cast<int>(CellState::kFree);
constexpr int kWall = static_cast<int>(CellState::kOccupied);

/// Three rooms of 8 m x 8 m in a row, with doors of this width [m] between them; 5 cm for each pixel.
OccupancyGrid threeRooms(double door_m) {
  cv::Mat states(160, 484, CV_8UC1, cv::Scalar(kFree));
  states.row(0).setTo(kWall);
  states.row(159).setTo(kWall);
  for (const int column : {0, 160, 322, 482}) states.colRange(column, column + 2).setTo(kWall);
  const int door = static_cast<int>(door_m / 0.05);
  for (const int column : {160, 322}) states(cv::Rect(column, 70, 2, door)).setTo(kFree);
  return {*MapFrame::create(0.05, 484, 160, Pose2{{10.0, -3.0}, 0.0}), states};
}

}  // namespace

class RoomMapTest : public QObject {
  Q_OBJECT

 private slots:
  void doorsSeparateRooms() {
    const RoomMap map = RoomMap::find(threeRooms(0.9));
    QCOMPARE(map.rooms().size(), std::size_t(3));
    std::set<std::size_t> found;
    for (const double x : {14.0, 22.0, 30.0}) found.insert(map.roomAt({x, 1.0}).value());
    QCOMPARE(found.size(), std::size_t(3));
    for (std::size_t i = 0; i < 3; ++i) QCOMPARE(map.roomAt(map.rooms()[i].center).value(), i);
  }

  void wideOpeningsDoNot() { QCOMPARE(RoomMap::find(threeRooms(4.0)).rooms().size(), std::size_t(1)); }

  void cornersBelongToTheirRoom() {
    const RoomMap map = RoomMap::find(threeRooms(0.9));
    QCOMPARE(map.roomAt({10.1, -2.9}), map.roomAt({14.0, 1.0}));
    QCOMPARE(map.roomAt({17.9, 4.9}), map.roomAt({14.0, 1.0}));
  }

  void farAwayAndNonsenseAreNoRoom() {
    const RoomMap map = RoomMap::find(threeRooms(0.9));
    QVERIFY(!map.roomAt({500.0, 0.0}));
    QVERIFY(!map.roomAt({std::numeric_limits<double>::quiet_NaN(), 0.0}));
    QVERIFY(!map.roomAt({1e300, -1e300}));
  }

  void aBlueprintOfWallsHasNoRooms() {
    const OccupancyGrid walls(*MapFrame::create(0.05, 7, 5, Pose2{}), cv::Mat(5, 7, CV_8UC1, cv::Scalar(kWall)));
    QVERIFY(RoomMap::find(walls).rooms().empty());
    QVERIFY(!RoomMap::find(walls).roomAt({0.1, 0.1}));
  }
};

QTEST_GUILESS_MAIN(RoomMapTest)
#include "room_map_test.moc"
