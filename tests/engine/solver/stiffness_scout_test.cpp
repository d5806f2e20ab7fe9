// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/solver/stiffness_scout.h"

#include <QTest>

#include <memory>
#include <random>

#include "cad2slam/projection/make_projector.h"
#include "support/synthetic_buildings.h"

namespace cad2slam {

namespace {

/// A hall that sags as a whole, which knows nothing of walls.
Eigen::Vector2d sagging(const Eigen::Vector2d& p) {
  return {p.x() + 0.002 * p.x() * p.y(), p.y() + 0.01 * p.x() * p.x()};
}

}  // namespace

class StiffnessScoutTest : public QObject {
  Q_OBJECT

 private slots:
  void fewAnchorsAreLocal();
  void aSaggingHallIsSmooth();
  void choosingAgainIsTheSame();
  void reportedPlacesAreTheProjectors();
  void aGivenStiffnessTakesNoPlate();
};

void StiffnessScoutTest::fewAnchorsAreLocal() {
  const auto mesh = testing::meshOf(testing::uShapedCorridor(), 0.5);
  StiffnessScout scout(*mesh);
  const Stiffness choice = scout.choose(testing::anchorsAt(*mesh, 4, 1, sagging), defaultSettings(Model::kStretch));
  QVERIFY(choice == Stiffness::kLocal);
}

void StiffnessScoutTest::aSaggingHallIsSmooth() {
  const auto mesh = testing::meshOf(testing::uShapedCorridor(), 0.5);
  StiffnessScout scout(*mesh);
  QVERIFY(scout.choose(testing::anchorsAt(*mesh, 30, 2, sagging), defaultSettings(Model::kStretch)) ==
          Stiffness::kSmooth);
}

void StiffnessScoutTest::choosingAgainIsTheSame() {
  const auto mesh = testing::meshOf(testing::uShapedCorridor(), 0.5);
  StiffnessScout scout(*mesh);
  const AnchorList anchors = testing::anchorsAt(*mesh, 20, 3, sagging);
  const Stiffness first = scout.choose(anchors, defaultSettings(Model::kStretch));
  (void)scout.choose(testing::anchorsAt(*mesh, 12, 4, sagging), defaultSettings(Model::kStretch));
  const Stiffness again = scout.choose(anchors, defaultSettings(Model::kStretch));
  QVERIFY(first == again);
}

void StiffnessScoutTest::reportedPlacesAreTheProjectors() {
  const auto mesh = testing::meshOf(testing::uShapedCorridor(), 0.5);
  const AnchorList anchors = testing::anchorsAt(*mesh, 30, 5, sagging);
  const auto solution = MeshSolver(mesh).solve(anchors, defaultSettings(Model::kStretch));
  QVERIFY(solution && solution->plate_share > 0.0);
  const auto projector = makeProjector(*mesh, *solution);
  QVERIFY(projector.has_value());
  for (std::size_t i = 0; i < anchors.size(); ++i) {
    const Projection there = projector->slamFromBlueprint({anchors[i].in_blueprint, 0.0});
    QVERIFY((there.pose.translation - solution->anchors[i].predicted).norm() < 1e-9);
  }
}

void StiffnessScoutTest::aGivenStiffnessTakesNoPlate() {
  const auto mesh = testing::meshOf(testing::uShapedCorridor(), 0.5);
  const AnchorList anchors = testing::anchorsAt(*mesh, 30, 5, sagging);
  const SolverSettings settings = withStiffness(defaultSettings(Model::kStretch), Stiffness::kSmooth);
  const auto solution = MeshSolver(mesh).solve(anchors, settings);
  QVERIFY(solution && solution->plate_share == 0.0);
  QVERIFY(solution->settings.stiffness == Stiffness::kSmooth);
}

}  // namespace cad2slam

QTEST_GUILESS_MAIN(cad2slam::StiffnessScoutTest)
#include "stiffness_scout_test.moc"
