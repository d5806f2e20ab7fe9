// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/solver/mixing.h"

#include <QTest>

#include <algorithm>
#include <cmath>
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
      *MeshSolver(mesh).solve(anchors, withStiffness(defaultSettings(Model::kStretch), Stiffness::kLocal));

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

class MixingTest : public QObject {
  Q_OBJECT

 private slots:
  void blendedIsTheProjector();
  void nothingOfThePlateChangesNothing();
  void allOfThePlateIsThePlate();
  void halfLiesBetween();
  void aFoldedPlateIsRefused();
  void theBetterOneGetsTheLargerShare();
  void fewAnchorsTakeNoPlate();
  void theMixtureLeavesOutAtLeastAsWell();
  void theGlobalFitTakesOverWhereNothingBends();
  void aBendIsNotNoise();
  void oneStraightWingDoesNotCount();
  void oneWrongAnchorDoesNotCount();
  void allOfTheGlobalFitIsTheGlobalFit();
};

void MixingTest::blendedIsTheProjector() {
  const Fitted fitted;
  const Projector projector = *makeProjector(*fitted.mesh, fitted.solution);
  std::mt19937 random(4);
  for (int k = 0; k < 500; ++k) {
    const Eigen::Vector2d place = testing::randomPlace(*fitted.mesh, random);
    const Projection there = projector.slamFromBlueprint({place, 0.0});
    QVERIFY((there.pose.translation - blended(*fitted.mesh, fitted.solution, place)).norm() < 1e-9);
  }
}

void MixingTest::nothingOfThePlateChangesNothing() {
  const Fitted fitted;
  Solution mixed = fitted.solution;
  QVERIFY(mixIn(atNodes(fitted.plate(bent), *fitted.mesh), 0.0, fitted.allNodes(), mixed));
  for (std::size_t i = 0; i < mixed.node_slam.size(); ++i) {
    QVERIFY((mixed.node_slam[i].translation - fitted.solution.node_slam[i].translation).norm() < 1e-12);
    QVERIFY((mixed.node_stretch[i] - fitted.solution.node_stretch[i]).norm() < 1e-12);
  }
}

/// Also where the plate shears, which a node cannot: the blend makes up for it inside the mesh.
void MixingTest::allOfThePlateIsThePlate() {
  const Fitted fitted;
  const ThinPlateFit plate = fitted.plate(bent);
  Solution mixed = fitted.solution;
  QVERIFY(mixIn(atNodes(plate, *fitted.mesh), 1.0, fitted.allNodes(), mixed));
  std::mt19937 random(5);
  for (int k = 0; k < 500; ++k) {
    const Eigen::Vector2d place = testing::randomPlace(*fitted.mesh, random);
    QVERIFY((blended(*fitted.mesh, mixed, place) - plate * place).norm() < 0.02);
  }
}

void MixingTest::halfLiesBetween() {
  const Fitted fitted;
  const ThinPlateFit plate = fitted.plate(bent);
  Solution mixed = fitted.solution;
  QVERIFY(mixIn(atNodes(plate, *fitted.mesh), 0.5, fitted.allNodes(), mixed));
  QCOMPARE(mixed.plate_share, 0.5);
  for (NodeIndex i = 0; i < fitted.mesh->nodeCount(); ++i) {
    const Eigen::Vector2d middle = 0.5 * (fitted.solution.node_slam[i].translation + plate * fitted.mesh->centers()[i]);
    QVERIFY((mixed.node_slam[i].translation - middle).norm() < 1e-12);
  }
}

void MixingTest::aFoldedPlateIsRefused() {
  const Fitted fitted;
  const ThinPlateFit mirrored = fitted.plate([](const Eigen::Vector2d& p) { return Eigen::Vector2d(-p.x(), p.y()); });
  Solution mixed = fitted.solution;
  QVERIFY(!mixIn(atNodes(mirrored, *fitted.mesh), 0.5, fitted.allNodes(), mixed));
  QVERIFY(mixed.plate_share == 0.0);
  QVERIFY(mixed.node_slam[3].translation == fitted.solution.node_slam[3].translation);
}

void MixingTest::theBetterOneGetsTheLargerShare() {
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

void MixingTest::theMixtureLeavesOutAtLeastAsWell() {
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

void MixingTest::fewAnchorsTakeNoPlate() {
  Fitted fitted;
  fitted.anchors.resize(19);
  fitted.solution = *MeshSolver(fitted.mesh)
                         .solve(fitted.anchors, withStiffness(defaultSettings(Model::kStretch), Stiffness::kLocal));
  QVERIFY(plateShare(fitted.anchors, fitted.solution, fitted.plate(bent)) == 0.0);
}

namespace {

constexpr double kClicks_m = 0.05;

AnchorList clicked(AnchorList anchors, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0.0, kClicks_m);
  for (Anchor& anchor : anchors) anchor.in_slam += Eigen::Vector2d(noise(random), noise(random));
  return anchors;
}

Solution solved(const std::shared_ptr<const Mesh>& mesh, const AnchorList& anchors) {
  return *MeshSolver(mesh).solve(anchors, defaultSettings(Model::kStretch));
}

/// Mean distance of the solution to the true map, over all nodes.
double trueError(const Mesh& mesh, const Solution& solution,
                 const std::function<Eigen::Vector2d(const Eigen::Vector2d&)>& map) {
  double sum = 0.0;
  for (NodeIndex i = 0; i < mesh.nodeCount(); ++i) {
    sum += (solution.node_slam[i].translation - map(mesh.centers()[i])).norm();
  }
  return sum / static_cast<double>(mesh.nodeCount());
}

}  // namespace

/// A SLAM map without any bend, clicked with noise: the answer is as good as the similarity.
void MixingTest::theGlobalFitTakesOverWhereNothingBends() {
  const auto mesh = testing::meshOf(testing::uShapedCorridor(), 0.5);
  const auto turned = [](const Eigen::Vector2d& p) { return Eigen::Vector2d(3.0 - p.y(), p.x() - 7.0); };
  double similarity = 0.0;
  double mixture = 0.0;
  for (unsigned seed = 0; seed < 10; ++seed) {
    const AnchorList anchors = clicked(testing::anchorsAt(*mesh, 8, seed, turned), seed);
    Solution solution = solved(mesh, anchors);
    mixture += trueError(*mesh, solution, turned);
    mixInSimilarity(1.0, *mesh, Fitted().allNodes(), solution);
    similarity += trueError(*mesh, solution, turned);
  }
  QVERIFY2(mixture < 1.25 * similarity, qPrintable(QString("%1 %2").arg(mixture).arg(similarity)));
}

void MixingTest::aBendIsNotNoise() {
  const Fitted fitted;
  const Solution solution = solved(fitted.mesh, clicked(fitted.anchors, 1));
  QVERIFY(solution.similarity_share == 0.0);
}

/// Where most anchors lie in a wing that a similarity fits perfectly, the others still need the mesh.
void MixingTest::oneStraightWingDoesNotCount() {
  const auto mesh = testing::meshOf(testing::uShapedCorridor(), 0.5);
  const auto kinked = [](const Eigen::Vector2d& p) {
    return Eigen::Vector2d(p.x(), p.y() + 0.3 * std::max(0.0, p.x() - 12.0));
  };
  AnchorList anchors = testing::anchorsAt(*mesh, 60, 2, kinked);
  std::stable_partition(anchors.begin(), anchors.end(), [](const Anchor& a) { return a.in_blueprint.x() < 12.0; });
  const auto straight =
      std::count_if(anchors.begin(), anchors.end(), [](const Anchor& a) { return a.in_blueprint.x() < 12.0; });
  anchors.resize(std::min(anchors.size(), static_cast<std::size_t>(straight + straight / 2)));
  QVERIFY(static_cast<std::size_t>(straight) < anchors.size());
  const Solution solution = solved(mesh, anchors);
  QVERIFY(solution.similarity_share == 0.0);
}

void MixingTest::oneWrongAnchorDoesNotCount() {
  const auto mesh = testing::meshOf(testing::uShapedCorridor(), 0.5);
  const auto same = [](const Eigen::Vector2d& p) { return p; };
  AnchorList anchors = clicked(testing::anchorsAt(*mesh, 12, 3, same), 3);
  anchors[4].in_slam += Eigen::Vector2d(8.0, -5.0);
  QVERIFY(solved(mesh, anchors).similarity_share > 0.3);
}

void MixingTest::allOfTheGlobalFitIsTheGlobalFit() {
  const Fitted fitted;
  Solution mixed = fitted.solution;
  mixInSimilarity(1.0, *fitted.mesh, fitted.allNodes(), mixed);
  std::mt19937 random(5);
  for (int k = 0; k < 200; ++k) {
    const Eigen::Vector2d place = testing::randomPlace(*fitted.mesh, random);
    QVERIFY((blended(*fitted.mesh, mixed, place) - mixed.global_fit * place).norm() < 1e-9);
  }
}

}  // namespace cad2slam

QTEST_GUILESS_MAIN(cad2slam::MixingTest)
#include "mixing_test.moc"
