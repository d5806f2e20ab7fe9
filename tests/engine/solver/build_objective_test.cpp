// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/solver/build_objective.h"

#include <QtTest>

#include "support/synthetic_buildings.h"

namespace cad2slam {
namespace {

using Eigen::Vector2d;

/// Two rooms of 6 x 6 m; anchors in both, in the first, or in the first and once in the second.
std::shared_ptr<const Mesh> twoRooms(double cell_size_m) {
  const MapFrame frame = *MapFrame::create(0.1, 140, 60, {{0.0, 0.0}, 0.0});
  return testing::meshOf(testing::drawGrid(frame, [](int column, int) { return column % 80 < 60; }), cell_size_m);
}

AnchorList anchorsAtPlaces(const std::vector<Vector2d>& places) {
  AnchorList anchors;
  for (const Vector2d& place : places) {
    anchors.push_back({static_cast<AnchorId>(anchors.size()), place, place, true, {}, {}});
  }
  return anchors;
}

const std::vector<Vector2d> kFirstRoom{{1.0, 1.0}, {5.0, 2.0}, {3.0, 5.0}};

}  // namespace

class BuildObjectiveTest : public QObject {
  Q_OBJECT
 private slots:
  void onlyAnchoredRoomsAreActive();
  void oneAnchorLeavesTheHeadingToAPrior();
  void disabledAnchorsLeaveNoTrace();
  void weightsDoNotDependOnTheCellSize();
  void automaticWeightsAreFilledIn();
  void startIsTheGlobalFitOrTheLastSolution();
};

void BuildObjectiveTest::onlyAnchoredRoomsAreActive() {
  const auto mesh = twoRooms(1.0);
  const SolverSettings settings = withAutomaticWeights(defaultSettings(Model::kStretch), *mesh, 1.0);
  const Objective objective = buildObjective(*mesh, anchorsAtPlaces(kFirstRoom), settings, {});
  QCOMPARE(objective.nodeCount(), std::size_t{36});
  QCOMPARE(objective.edges.size(), std::size_t{60});
  QCOMPARE(objective.size(), std::size_t{36 * 5});
  const std::vector<std::uint32_t> numbers = activeNumbers(objective, mesh->nodeCount());
  for (std::uint32_t node = 0; node < mesh->nodeCount(); ++node) {
    QCOMPARE(numbers[node] != kInactive, mesh->components()[node] == 0);
    if (numbers[node] != kInactive) QCOMPARE(objective.active_nodes[numbers[node]], node);
  }
}

void BuildObjectiveTest::oneAnchorLeavesTheHeadingToAPrior() {
  const auto mesh = twoRooms(1.0);
  const SolverSettings settings = withAutomaticWeights(defaultSettings(Model::kRigid), *mesh, 1.0);
  AnchorList anchors = anchorsAtPlaces(kFirstRoom);
  anchors.push_back({9, {11.0, 3.0}, {11.0, 3.0}, true, {}, {}});
  const Objective objective = buildObjective(*mesh, anchors, settings, {1.0, 0.6, {0.0, 0.0}});
  QCOMPARE(objective.nodeCount(), mesh->nodeCount());
  QCOMPARE(objective.prior_heading, 0.6);
  for (std::size_t k = 0; k < objective.nodeCount(); ++k) {
    QCOMPARE(objective.heading_prior[k] > 0.0, mesh->components()[objective.active_nodes[k]] == 1);
  }
}

void BuildObjectiveTest::disabledAnchorsLeaveNoTrace() {
  const auto mesh = twoRooms(1.0);
  const SolverSettings settings = withAutomaticWeights(defaultSettings(Model::kStretch), *mesh, 1.0);
  AnchorList anchors = anchorsAtPlaces(kFirstRoom);
  anchors.push_back({9, {11.0, 3.0}, {11.0, 3.0}, false, {}, {}});
  const Objective objective = buildObjective(*mesh, anchors, settings, {});
  QCOMPARE(objective.nodeCount(), std::size_t{36});
  QCOMPARE(objective.anchors.size(), std::size_t{3});
}

void BuildObjectiveTest::weightsDoNotDependOnTheCellSize() {
  // A field of stretch costs the same on coarse and fine tiles: the prior is one per area.
  const auto priorOf = [](double cell_size_m) {
    const auto mesh = twoRooms(cell_size_m);
    const SolverSettings settings = withAutomaticWeights(defaultSettings(Model::kStretch), *mesh, 1.0);
    const Objective objective = buildObjective(*mesh, anchorsAtPlaces(kFirstRoom), settings, {});
    return objective.sqrt_prior * objective.sqrt_prior * static_cast<double>(objective.nodeCount());
  };
  QVERIFY(std::abs(priorOf(0.5) - priorOf(1.0)) < 1e-9 * priorOf(1.0));
}

void BuildObjectiveTest::automaticWeightsAreFilledIn() {
  const auto mesh = twoRooms(1.0);
  SolverSettings settings = defaultSettings(Model::kStretch);
  settings.lambda_theta.reset();
  const double filled = *withAutomaticWeights(settings, *mesh, 2.0).lambda_theta;
  QVERIFY(filled > 0.0);
  QVERIFY(std::abs(filled - 2.0 * *withAutomaticWeights(settings, *mesh, 1.0).lambda_theta) < 1e-12 * filled);
  settings.lambda_theta = 7.0;
  QCOMPARE(*withAutomaticWeights(settings, *mesh, 2.0).lambda_theta, 7.0);
}

void BuildObjectiveTest::startIsTheGlobalFitOrTheLastSolution() {
  const auto mesh = twoRooms(1.0);
  const SolverSettings settings = withAutomaticWeights(defaultSettings(Model::kStretch), *mesh, 1.0);
  const Similarity2 fit{1.2, 0.7, {3.0, 4.0}};
  const Objective objective = buildObjective(*mesh, anchorsAtPlaces(kFirstRoom), settings, fit);
  const Eigen::VectorXd cold = startingPoint(objective, *mesh, fit, nullptr);
  Solution last;
  last.settings = settings;
  last.node_slam.assign(mesh->nodeCount(), {{1.0, 2.0}, 3.0});
  last.node_stretch.assign(mesh->nodeCount(), {0.1, -0.2});
  const Eigen::VectorXd warm = startingPoint(objective, *mesh, fit, &last);
  for (std::size_t k = 0; k < objective.nodeCount(); ++k) {
    const auto at = 5 * static_cast<Eigen::Index>(k);
    const Vector2d expected = fit * mesh->centers()[objective.active_nodes[k]];
    QVERIFY((cold.segment<2>(at) - expected).norm() < 1e-12);
    QVERIFY((cold.segment<3>(at + 2) - Eigen::Vector3d(0.7, 0.0, 0.0)).norm() < 1e-12);
    Eigen::VectorXd stored(5);
    stored << 1.0, 2.0, 3.0, 0.1, -0.2;
    QVERIFY(warm.segment(at, 5) == stored);
  }
  // Where something was mixed in, the minimum beside it is the start.
  last.minimum = NodeStates{last.node_slam, last.node_stretch};
  last.node_slam.assign(mesh->nodeCount(), {});
  last.node_stretch.assign(mesh->nodeCount(), {0.0, 0.0});
  QVERIFY(startingPoint(objective, *mesh, fit, &last) == warm);
  // A solution of another model or mesh is no start.
  last.settings.model = Model::kRigid;
  QVERIFY(startingPoint(objective, *mesh, fit, &last) == cold);
  last.settings.model = Model::kStretch;
  last.node_slam.pop_back();
  QVERIFY(startingPoint(objective, *mesh, fit, &last) == cold);
}

}  // namespace cad2slam

QTEST_GUILESS_MAIN(cad2slam::BuildObjectiveTest)
#include "build_objective_test.moc"
