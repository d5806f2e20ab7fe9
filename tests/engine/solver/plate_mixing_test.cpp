// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/solver/plate_mixing.h"

#include <QTest>

#include <functional>
#include <memory>
#include <numeric>
#include <random>
#include <vector>

#include "cad2slam/projection/make_projector.h"
#include "cad2slam/solver/mesh_solver.h"
#include "support/synthetic_buildings.h"

namespace cad2slam {
namespace {

Eigen::Vector2d bent(const Eigen::Vector2d& p) {
  return {1.01 * p.x() + 0.002 * p.x() * p.y(), 0.99 * p.y() + 0.002 * p.x() * p.x() + 0.02 * p.x()};
}

struct Fitted {
  std::shared_ptr<const Mesh> mesh = testing::meshOf(testing::uShapedCorridor(), 0.5);
  AnchorList anchors = testing::anchorsAt(*mesh, 40, 3, bent);
  Solution solution =
      *MeshSolver(mesh).solve(anchors, withStiffness(defaultSettings(Model::kStretch), Stiffness::kBalanced));

  [[nodiscard]] std::vector<NodeIndex> allNodes() const {
    std::vector<NodeIndex> nodes(mesh->nodeCount());
    std::iota(nodes.begin(), nodes.end(), 0U);
    return nodes;
  }
  [[nodiscard]] ThinPlateFit plate(const std::function<Eigen::Vector2d(const Eigen::Vector2d&)>& map) const {
    std::vector<PointPair> pairs;
    for (const Anchor& anchor : anchors) pairs.push_back({anchor.in_blueprint, map(anchor.in_blueprint)});
    return *ThinPlateFit::create(pairs, 1.0);
  }
};

}  // namespace

class PlateMixingTest : public QObject {
  Q_OBJECT

 private slots:
  void blendedIsTheProjector();
  void nothingOfThePlateChangesNothing();
  void allOfThePlateIsThePlate();
  void halfLiesBetween();
  void aFoldedPlateIsRefused();
  void theBetterOneGetsTheLargerShare();
  void theMixtureLeavesOutAtLeastAsWell();
};

void PlateMixingTest::blendedIsTheProjector() {
  const Fitted fitted;
  const Projector projector = *makeProjector(*fitted.mesh, fitted.solution);
  std::mt19937 random(4);
  for (int k = 0; k < 500; ++k) {
    const Eigen::Vector2d place = testing::randomPlace(*fitted.mesh, random);
    const Projection there = projector.slamFromBlueprint({place, 0.0});
    QVERIFY((there.pose.translation - blended(*fitted.mesh, fitted.solution, place)).norm() < 1e-9);
  }
}

void PlateMixingTest::nothingOfThePlateChangesNothing() {
  const Fitted fitted;
  Solution mixed = fitted.solution;
  QVERIFY(mixIn(fitted.plate(bent), 0.0, *fitted.mesh, fitted.allNodes(), mixed));
  for (std::size_t i = 0; i < mixed.node_slam.size(); ++i) {
    QVERIFY((mixed.node_slam[i].translation - fitted.solution.node_slam[i].translation).norm() < 1e-12);
    QVERIFY((mixed.node_stretch[i] - fitted.solution.node_stretch[i]).norm() < 1e-12);
  }
}

/// Also where the plate shears, which a node cannot: the blend makes up for it inside the mesh.
void PlateMixingTest::allOfThePlateIsThePlate() {
  const Fitted fitted;
  const ThinPlateFit plate = fitted.plate(bent);
  Solution mixed = fitted.solution;
  QVERIFY(mixIn(plate, 1.0, *fitted.mesh, fitted.allNodes(), mixed));
  std::mt19937 random(5);
  for (int k = 0; k < 500; ++k) {
    const Eigen::Vector2d place = testing::randomPlace(*fitted.mesh, random);
    QVERIFY((blended(*fitted.mesh, mixed, place) - plate * place).norm() < 0.02);
  }
}

void PlateMixingTest::halfLiesBetween() {
  const Fitted fitted;
  const ThinPlateFit plate = fitted.plate(bent);
  Solution mixed = fitted.solution;
  QVERIFY(mixIn(plate, 0.5, *fitted.mesh, fitted.allNodes(), mixed));
  QCOMPARE(mixed.plate_share, 0.5);
  for (NodeIndex i = 0; i < fitted.mesh->nodeCount(); ++i) {
    const Eigen::Vector2d middle = 0.5 * (fitted.solution.node_slam[i].translation + plate * fitted.mesh->centers()[i]);
    QVERIFY((mixed.node_slam[i].translation - middle).norm() < 1e-12);
  }
}

void PlateMixingTest::aFoldedPlateIsRefused() {
  const Fitted fitted;
  const ThinPlateFit mirrored = fitted.plate([](const Eigen::Vector2d& p) { return Eigen::Vector2d(-p.x(), p.y()); });
  Solution mixed = fitted.solution;
  QVERIFY(!mixIn(mirrored, 0.5, *fitted.mesh, fitted.allNodes(), mixed));
  QVERIFY(mixed.plate_share == 0.0);
  QVERIFY(mixed.node_slam[3].translation == fitted.solution.node_slam[3].translation);
}

void PlateMixingTest::theBetterOneGetsTheLargerShare() {
  const Fitted fitted;
  QVERIFY(plateShare(fitted.anchors, fitted.solution, fitted.plate(bent)) > 0.5);
  // Of a plate whose anchors are noise, nothing is taken.
  std::mt19937 random(6);
  std::normal_distribution<double> noise(0.0, 2.0);
  const ThinPlateFit noisy = fitted.plate([&](const Eigen::Vector2d& p) {
    return Eigen::Vector2d(bent(p) + Eigen::Vector2d(noise(random), noise(random)));
  });
  QVERIFY(plateShare(fitted.anchors, fitted.solution, noisy) == 0.0);
}

void PlateMixingTest::theMixtureLeavesOutAtLeastAsWell() {
  const Fitted fitted;
  const auto mixed = MeshSolver(fitted.mesh).solve(fitted.anchors, defaultSettings(Model::kStretch));
  QVERIFY(mixed && mixed->plate_share > 0.0);
  const auto alone =
      MeshSolver(fitted.mesh).solve(fitted.anchors, withStiffness(mixed->settings, mixed->settings.stiffness));
  QVERIFY(alone && alone->plate_share == 0.0);
  const auto mean = [](const Solution& solution) {
    double sum = 0.0;
    for (const AnchorFit& fit : solution.anchors) sum += fit.leave_one_out_m;
    return sum / static_cast<double>(solution.anchors.size());
  };
  QVERIFY(mean(*mixed) < 1.06 * mean(*alone));
}

}  // namespace cad2slam

QTEST_GUILESS_MAIN(cad2slam::PlateMixingTest)
#include "plate_mixing_test.moc"
