// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/solver/objective.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <QtTest>

#include <functional>
#include <random>

#include "cad2slam/solver/build_objective.h"
#include "support/synthetic_buildings.h"

namespace cad2slam {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// A corridor with seven anchors and a room of its own with one, which leaves the room's heading to the prior.
struct Case {
  std::shared_ptr<const Mesh> mesh;
  AnchorList anchors;
  Similarity2 fit;
  Objective objective;
};

Vector2d bend(const Vector2d& p) {
  return rotationMatrix(3.0) * p + Vector2d(0.3 * std::sin(0.4 * p.y()), 0.2 * p.x());
}

Case makeCase(Model model, bool cauchy, double scale = 1.0) {
  const MapFrame frame = *MapFrame::create(0.1, 220, 60, {{-2.0, 1.0}, 0.0});
  Case made;
  made.mesh =
      testing::meshOf(testing::drawGrid(frame, [](int column, int) { return column < 160 || column >= 180; }), 2.0);
  made.anchors = testing::anchorsAt(*made.mesh, 8, 3, bend);
  for (std::size_t k = 0; k < 7; ++k) {
    made.anchors[k].in_blueprint = {-1.7 + 2.1 * static_cast<double>(k), 1.4 + 0.7 * static_cast<double>(k)};
  }
  made.anchors[7].in_blueprint = {18.6, 3.3};
  for (Anchor& anchor : made.anchors) anchor.in_slam = bend(anchor.in_blueprint) + Vector2d(0.4, -0.9);
  made.fit = {scale, 2.9, {0.2, -0.3}};
  SolverSettings settings = withAutomaticWeights(defaultSettings(model), *made.mesh, scale);
  settings.loss_width_m = cauchy ? std::optional(0.6) : std::nullopt;
  made.objective = buildObjective(*made.mesh, made.anchors, settings, made.fit);
  return made;
}

/// Nodes near the warp, with headings far beyond one turn and no two neighbours half a turn apart, where the wrapped
/// difference has no derivative.
VectorXd randomState(const Case& made, std::mt19937& random) {
  std::normal_distribution<double> noise(0.0, 0.4);
  std::uniform_real_distribution<double> turn(-9.0, 9.0);
  const double heading = turn(random);
  VectorXd x = startingPoint(made.objective, *made.mesh, made.fit, nullptr);
  for (Eigen::Index k = 0; k < x.size(); ++k) x[k] += noise(random);
  for (std::size_t node = 0; node < made.objective.nodeCount(); ++node) {
    x[static_cast<Eigen::Index>(node) * made.objective.unknowns + 2] += heading;
  }
  return x;
}

/// Central differences of a vector function.
Eigen::MatrixXd differences(const std::function<VectorXd(const VectorXd&)>& function, const VectorXd& x) {
  constexpr double kStep = 1e-6;
  Eigen::MatrixXd slopes(function(x).size(), x.size());
  for (Eigen::Index k = 0; k < x.size(); ++k) {
    const VectorXd step = kStep * VectorXd::Unit(x.size(), k);
    slopes.col(k) = (function(x + step) - function(x - step)) / (2.0 * kStep);
  }
  return slopes;
}

double farApart(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  return (a - b).cwiseAbs().maxCoeff() / std::max(1.0, b.cwiseAbs().maxCoeff());
}

Matrix3d matrixOf(double x, double y, double heading) {
  Matrix3d matrix;
  matrix << std::cos(heading), -std::sin(heading), x, std::sin(heading), std::cos(heading), y, 0.0, 0.0, 1.0;
  return matrix;
}

/// PAPER.md eq. 3 and 4 with homogeneous matrices and the information matrix of section III-B, over all pairs of nodes.
double costOfThePaper(const Case& made, const VectorXd& x) {
  const Mesh& mesh = *made.mesh;
  const auto slam_from = [&](std::size_t node) {
    const auto at = 3 * static_cast<Eigen::Index>(node);
    return matrixOf(x[at], x[at + 1], x[at + 2]);
  };
  const auto blueprint_from = [&](std::size_t node) {
    return matrixOf(mesh.centers()[node].x(), mesh.centers()[node].y(), 0.0);
  };
  double twice_cost = 0.0;
  for (std::size_t i = 0; i < mesh.nodeCount(); ++i) {
    for (std::size_t j = 0; j < mesh.nodeCount(); ++j) {
      const TileCoordinate a = mesh.tiles()[i];
      const TileCoordinate b = mesh.tiles()[j];
      const bool right_of = b.column == a.column + 1 && b.row == a.row;
      const bool above = b.column == a.column && b.row == a.row + 1;
      if (!right_of && !above) continue;
      const Matrix3d z = blueprint_from(i).inverse() * blueprint_from(j);
      const Matrix3d error_matrix = z.inverse() * slam_from(i).inverse() * slam_from(j);
      const Vector3d error(error_matrix(0, 2), error_matrix(1, 2), std::atan2(error_matrix(1, 0), error_matrix(0, 0)));
      const Vector2d t = z.topRightCorner<2, 1>();
      Eigen::Matrix2d r;
      r << t.x(), -t.y(), t.y(), t.x();
      r /= t.norm();
      Matrix3d omega = Matrix3d::Zero();
      omega.topLeftCorner<2, 2>() = r * Vector2d(1.0, 10.0).asDiagonal() * r.transpose();
      omega(2, 2) = 10.0;
      twice_cost += error.dot(omega * error);
    }
  }
  for (const Anchor& anchor : made.anchors) {
    std::size_t nearest = 0;
    for (std::size_t node = 1; node < mesh.nodeCount(); ++node) {
      const auto distance = [&](std::size_t k) { return (mesh.centers()[k] - anchor.in_blueprint).norm(); };
      if (distance(node) < distance(nearest)) nearest = node;
    }
    const Vector3d error = slam_from(nearest).inverse() * Vector3d(anchor.in_slam.homogeneous()) -
                           blueprint_from(nearest).inverse() * Vector3d(anchor.in_blueprint.homogeneous());
    twice_cost += 100.0 * error.head<2>().squaredNorm();
  }
  return 0.5 * twice_cost;
}

}  // namespace

class ObjectiveTest : public QObject {
  Q_OBJECT
 private slots:
  void gradientIsTheDerivativeOfTheCost_data() { models(); }
  void gradientIsTheDerivativeOfTheCost();
  void edgeDerivativesAgreeWithDifferences_data() { models(); }
  void edgeDerivativesAgreeWithDifferences();
  void anchorDerivativesAgreeWithDifferences_data() { models(); }
  void anchorDerivativesAgreeWithDifferences();
  void rigidIsThePaper();
  void stretchAtRestIsRigid();
  void turningBothMapsChangesNothing_data() { models(); }
  void turningBothMapsChangesNothing();
  void lossIsQuadraticForSmallResidualsAndFlatForLarge();

 private:
  static void models();
};

void ObjectiveTest::models() {
  QTest::addColumn<bool>("stretch");
  QTest::addColumn<bool>("cauchy");
  for (const bool stretch : {false, true}) {
    for (const bool cauchy : {false, true}) {
      QTest::addRow("%s, %s", stretch ? "stretch" : "rigid", cauchy ? "Cauchy" : "squared") << stretch << cauchy;
    }
  }
}

void ObjectiveTest::gradientIsTheDerivativeOfTheCost() {
  QFETCH(bool, stretch);
  QFETCH(bool, cauchy);
  const Case made = makeCase(stretch ? Model::kStretch : Model::kRigid, cauchy, 1.1);
  const Objective& objective = made.objective;
  const auto open = std::count_if(objective.heading_prior.begin(), objective.heading_prior.end(),
                                  [](double weight) { return weight > 0.0; });
  QCOMPARE(open, std::ptrdiff_t{6});  // the nodes of the room with one anchor
  std::mt19937 random(1);
  for (int round = 0; round < 5; ++round) {
    const VectorXd x = randomState(made, random);
    VectorXd gradient(x.size());
    const double cost = gradientAt(objective, x.data(), gradient.data());
    QVERIFY(std::abs(cost - costAt(objective, x.data())) <= 1e-12 * cost);
    const auto cost_of = [&](const VectorXd& at) { return VectorXd::Constant(1, costAt(objective, at.data())); };
    QVERIFY(farApart(gradient.transpose(), differences(cost_of, x)) < 1e-6);
  }
}

void ObjectiveTest::edgeDerivativesAgreeWithDifferences() {
  QFETCH(bool, stretch);
  QFETCH(bool, cauchy);
  const Case made = makeCase(stretch ? Model::kStretch : Model::kRigid, cauchy);
  const Objective& objective = made.objective;
  const Eigen::Index unknowns = objective.unknowns;
  std::mt19937 random(2);
  const VectorXd x = randomState(made, random);
  for (const EdgeTerm& edge : objective.edges) {
    VectorXd both(2 * unknowns);
    both << x.segment(edge.from * unknowns, unknowns), x.segment(edge.to * unknowns, unknowns);
    const EdgeLinearisation at = linearise(objective, edge, both.data(), both.data() + unknowns);
    const auto residual = [&](const VectorXd& nodes) -> VectorXd {
      return residualOf(objective, edge, nodes.data(), nodes.data() + unknowns);
    };
    QVERIFY((at.residual - residual(both)).norm() < 1e-12);
    const Eigen::MatrixXd slopes = differences(residual, both);
    QVERIFY(farApart(at.from.leftCols(unknowns), slopes.topLeftCorner(2, unknowns)) < 1e-7);
    QVERIFY(farApart(at.to.leftCols(unknowns), slopes.topRightCorner(2, unknowns)) < 1e-7);
  }
}

void ObjectiveTest::anchorDerivativesAgreeWithDifferences() {
  QFETCH(bool, stretch);
  QFETCH(bool, cauchy);
  const Case made = makeCase(stretch ? Model::kStretch : Model::kRigid, cauchy);
  const Objective& objective = made.objective;
  const Eigen::Index unknowns = objective.unknowns;
  std::mt19937 random(3);
  const VectorXd x = randomState(made, random);
  for (const AnchorTerm& anchor : objective.anchors) {
    const Eigen::MatrixXd slopes =
        differences([&](const VectorXd& at) -> VectorXd { return residualOf(objective, anchor, at.data()); }, x);
    Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(2, x.size());
    for (std::size_t k = 0; k < anchor.blend.count; ++k) {
      expected.middleCols(anchor.blend.nodes[k] * unknowns, unknowns) =
          derivativeOf(objective, anchor, k, x.data()).leftCols(unknowns);
    }
    QVERIFY(farApart(slopes, expected) < 1e-7);
  }
}

void ObjectiveTest::rigidIsThePaper() {
  Case made = makeCase(Model::kRigid, false);
  // The paper has no prior on headings; it is ours, for rooms with a single anchor.
  made.objective.heading_prior.assign(made.objective.nodeCount(), 0.0);
  QCOMPARE(made.objective.nodeCount(), made.mesh->nodeCount());
  std::mt19937 random(4);
  for (int round = 0; round < 10; ++round) {
    const VectorXd x = randomState(made, random);
    const double expected = costOfThePaper(made, x);
    QVERIFY(std::abs(costAt(made.objective, x.data()) - expected) < 1e-11 * expected);
  }
}

void ObjectiveTest::stretchAtRestIsRigid() {
  // With all stretches at 0 only the blend of the anchors differs between the models.
  Case rigid = makeCase(Model::kRigid, true);
  Case stretch = makeCase(Model::kStretch, true);
  rigid.objective.anchors.clear();
  stretch.objective.anchors.clear();
  stretch.objective.sqrt_lambda_theta = rigid.objective.sqrt_lambda_theta;
  std::mt19937 random(5);
  const VectorXd x = randomState(rigid, random);
  VectorXd with_stretch = VectorXd::Zero(static_cast<Eigen::Index>(stretch.objective.size()));
  for (Eigen::Index node = 0; node < x.size() / 3; ++node) with_stretch.segment<3>(5 * node) = x.segment<3>(3 * node);
  const double expected = costAt(rigid.objective, x.data());
  QVERIFY(std::abs(costAt(stretch.objective, with_stretch.data()) - expected) < 1e-12 * expected);
}

void ObjectiveTest::turningBothMapsChangesNothing() {
  QFETCH(bool, stretch);
  QFETCH(bool, cauchy);
  Case made = makeCase(stretch ? Model::kStretch : Model::kRigid, cauchy);
  std::mt19937 random(6);
  VectorXd x = randomState(made, random);
  const double before = costAt(made.objective, x.data());
  const Pose2 turned_from_slam{{12.0, -7.0}, 2.6};
  for (AnchorTerm& anchor : made.objective.anchors) anchor.target = turned_from_slam * anchor.target;
  made.objective.prior_heading += turned_from_slam.heading;
  for (Eigen::Index at = 0; at < x.size(); at += made.objective.unknowns) {
    x.segment<2>(at) = turned_from_slam * Vector2d(x.segment<2>(at));
    x[at + 2] += turned_from_slam.heading;
  }
  QVERIFY(std::abs(costAt(made.objective, x.data()) - before) < 1e-10 * before);
}

void ObjectiveTest::lossIsQuadraticForSmallResidualsAndFlatForLarge() {
  QCOMPARE(anchorCost(4.0, 100.0, 0.0), 200.0);
  QVERIFY(std::abs(anchorCost(1e-6, 100.0, 1.0) - 0.5e-4) < 1e-9);
  QVERIFY(anchorCost(900.0, 100.0, 1.0) < 0.01 * anchorCost(900.0, 100.0, 0.0));
  QCOMPARE(lossWeight(25.0, 0.0), 1.0);
  QCOMPARE(lossWeight(0.0, 1.0), 1.0);
  // The weight is the derivative of the cost by k |e|^2 / 2.
  for (const double squared : {0.01, 1.0, 30.0}) {
    const double slope = (anchorCost(squared + 1e-6, 7.0, 0.8) - anchorCost(squared - 1e-6, 7.0, 0.8)) / 2e-6;
    QVERIFY(std::abs(slope - 0.5 * 7.0 * lossWeight(squared, 0.8)) < 1e-7);
  }
}

}  // namespace cad2slam

QTEST_GUILESS_MAIN(cad2slam::ObjectiveTest)
#include "objective_test.moc"
