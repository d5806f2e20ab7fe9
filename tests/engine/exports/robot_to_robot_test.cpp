// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/exports/robot_to_robot.h"

#include <QtTest>

#include "support/bent_hall.h"

namespace cad2slam {
namespace {

const std::string kHash(64, 'a');

ProjectorData ofBlueprint(ProjectorData data, const std::string& hash = kHash) {
  data.info.blueprint = {"plan", hash, 0.05, 400, 200, {{1.0, 2.0}, 0.0}};
  return data;
}

Projector bent() {
  return *Projector::create(ofBlueprint(test::bentHallData()));
}

Projector straight() {
  return *Projector::create(ofBlueprint(test::straightHallData(1.1, {{7.0, -3.0}, 0.4})));
}

}  // namespace

class RobotToRobotTest : public QObject {
  Q_OBJECT
 private slots:
  void isOneProjectionAfterTheOther();
  void theWorseStatusCounts();
  void onlyTheSameBlueprintIsShared();
};

void RobotToRobotTest::isOneProjectionAfterTheOther() {
  const Projector first = bent();
  const Projector second = straight();
  const RobotToRobot there = *RobotToRobot::create(first, second);
  const RobotToRobot back = *RobotToRobot::create(second, first);
  for (const Pose2& pose : {Pose2{{3.2, 4.1}, 0.3}, Pose2{{12.9, 8.4}, -2.0}, Pose2{{19.0, 0.6}, 3.1}}) {
    const Pose2 start = first.slamFromBlueprint(pose).pose;
    const Projection found = there.project(start);
    QCOMPARE(found.status, ProjectionStatus::kInside);
    const Pose2 expected = second.slamFromBlueprint(pose).pose;
    QVERIFY((found.pose.translation - expected.translation).norm() < 1e-8);
    QVERIFY(std::cos(found.pose.heading - expected.heading) > 1.0 - 1e-12);
    QVERIFY((back.project(found.pose).pose.translation - start.translation).norm() < 1e-8);
  }
}

void RobotToRobotTest::theWorseStatusCounts() {
  ProjectorData half = ofBlueprint(test::straightHallData(1.0, {}));
  constexpr std::size_t kNodes = 100;  // the left ten columns
  half.node_tile.resize(kNodes);
  half.node_blueprint.resize(kNodes);
  half.node_slam.resize(kNodes);
  half.node_stretch.resize(kNodes);
  const Projector first = bent();
  const RobotToRobot into_half = *RobotToRobot::create(first, *Projector::create(half));
  const Pose2 start = first.slamFromBlueprint({{15.0, 5.0}, 0.0}).pose;
  const Projection refused = into_half.project(start);
  QCOMPARE(refused.status, ProjectionStatus::kOutside);
  QVERIFY(!refused.pose.isFinite());
  QCOMPARE(into_half.project(start, OutsidePolicy::kRigid).status, ProjectionStatus::kExtrapolated);
  // What was only a guess on the blueprint stays one, even where it comes to lie on the second mesh.
  const RobotToRobot from_half = *RobotToRobot::create(*Projector::create(half), first);
  QCOMPARE(from_half.project({{15.0, 5.0}, 0.0}, OutsidePolicy::kRigid).status, ProjectionStatus::kExtrapolated);
  QCOMPARE(from_half.project({{15.0, 5.0}, 0.0}).status, ProjectionStatus::kOutside);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  QCOMPARE(from_half.project({{nan, 5.0}, 0.0}).status, ProjectionStatus::kInvalid);
}

void RobotToRobotTest::onlyTheSameBlueprintIsShared() {
  const Projector known = bent();
  const Projector unknown = *Projector::create(test::bentHallData());
  const Projector other = *Projector::create(ofBlueprint(test::bentHallData(), std::string(64, 'b')));
  ProjectorData moved_data = ofBlueprint(test::bentHallData());
  moved_data.info.blueprint.metric_from_corner.translation.x() += 1e-3;
  const Projector moved = *Projector::create(moved_data);
  for (const Projector* wrong : {&unknown, &other, &moved}) {
    for (const auto& result : {RobotToRobot::create(known, *wrong), RobotToRobot::create(*wrong, known)}) {
      QVERIFY(!result);
      QCOMPARE(result.error().code, ErrorCode::kOutOfDomain);
      QVERIFY(!result.error().message.empty());
    }
  }
}

}  // namespace cad2slam

QTEST_APPLESS_MAIN(cad2slam::RobotToRobotTest)
#include "robot_to_robot_test.moc"
