// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/solver/normal_matrix.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <QtTest>

#include <random>

#include "cad2slam/solver/build_objective.h"
#include "support/synthetic_buildings.h"

namespace cad2slam {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;

struct Case {
  std::shared_ptr<const Mesh> mesh;
  Similarity2 fit{1.1, 2.0, {3.0, 1.0}};
  Objective objective;
  VectorXd x;
};

Case makeCase(bool stretch, std::size_t anchor_count = 9) {
  Case made;
  made.mesh = testing::meshOf(testing::uShapedCorridor(), 1.5);
  AnchorList anchors = testing::anchorsAt(*made.mesh, anchor_count, 5, [&](const Vector2d& p) -> Vector2d {
    return made.fit * p + Vector2d(std::sin(p.x()), std::cos(p.y()));
  });
  const Model model = stretch ? Model::kStretch : Model::kRigid;
  SolverSettings settings = withAutomaticWeights(defaultSettings(model), *made.mesh, made.fit.scale);
  settings.loss_width_m = 0.7;
  made.objective = buildObjective(*made.mesh, anchors, settings, made.fit);
  made.objective.heading_prior.assign(made.objective.nodeCount(), 0.0);
  made.objective.heading_prior[2] = 1.5;
  made.x = startingPoint(made.objective, *made.mesh, made.fit, nullptr);
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0.0, 0.2);
  for (double& unknown : made.x) unknown += noise(random);
  return made;
}

/// J^T W J, dense, from whole Jacobians of every term.
MatrixXd denseNormalMatrix(const Case& made) {
  const Objective& objective = made.objective;
  const Eigen::Index u = objective.unknowns;
  const auto size = static_cast<Eigen::Index>(objective.size());
  MatrixXd normal = MatrixXd::Zero(size, size);
  const auto add = [&](const MatrixXd& jacobian, double weight) {
    std::vector<Eigen::Index> columns;
    for (Eigen::Index column = 0; column < size; ++column) {
      if (!jacobian.col(column).isZero(0.0)) columns.push_back(column);
    }
    for (const Eigen::Index i : columns) {
      for (const Eigen::Index j : columns) normal(i, j) += weight * jacobian.col(i).dot(jacobian.col(j));
    }
  };
  for (const EdgeTerm& edge : objective.edges) {
    const EdgeLinearisation at = linearise(objective, edge, made.x.data() + edge.from * u, made.x.data() + edge.to * u);
    MatrixXd jacobian = MatrixXd::Zero(u, size);
    jacobian.block(0, edge.from * u, 2, u) = at.from.leftCols(u);
    jacobian.block(0, edge.to * u, 2, u) = at.to.leftCols(u);
    for (Eigen::Index q = 2; q < u; ++q) {
      const double slope = q == 2 ? objective.sqrt_lambda_theta : objective.sqrt_lambda_stretch;
      jacobian(q, edge.from * u + q) = -slope;
      jacobian(q, edge.to * u + q) = slope;
    }
    add(jacobian, 1.0);
  }
  for (Eigen::Index node = 0; node < size / u; ++node) {
    MatrixXd jacobian = MatrixXd::Zero(3, size);
    jacobian(0, node * u + 2) = objective.heading_prior[static_cast<std::size_t>(node)];
    if (u == kStretchUnknowns) {
      jacobian.block<2, 2>(1, node * u + 3) << objective.sqrt_prior, -objective.sqrt_prior, objective.sqrt_prior,
          objective.sqrt_prior;
    }
    add(jacobian, 1.0);
  }
  for (const AnchorTerm& anchor : objective.anchors) {
    MatrixXd jacobian = MatrixXd::Zero(2, size);
    for (std::size_t k = 0; k < anchor.blend.count; ++k) {
      jacobian.middleCols(anchor.blend.nodes[k] * u, u) = derivativeOf(objective, anchor, k, made.x.data()).leftCols(u);
    }
    const double squared = residualOf(objective, anchor, made.x.data()).squaredNorm();
    add(jacobian, objective.anchor_information * lossWeight(squared, objective.loss_width_m));
  }
  return normal;
}

}  // namespace

class NormalMatrixTest : public QObject {
  Q_OBJECT
 private slots:
  void manyAnchorsCostLittle();
  void solvesLikeADenseMatrix_data() { models(); }
  void solvesLikeADenseMatrix();
  void dampingScalesTheDiagonal();
  void inverseFormIsThatOfADenseMatrix_data() { models(); }
  void inverseFormIsThatOfADenseMatrix();
  void followsAChangeOfAnchors();
  void aFactorFollowsAFewAnchors();
  void aFactorKeepsWhatHoldsTheMesh();
  void theNextLayoutComesWhileTheFactorServes();
  void knowsWhatItCanNotFactorise();

 private:
  static void models();
};

void NormalMatrixTest::models() {
  QTest::addColumn<bool>("stretch");
  QTest::newRow("rigid") << false;
  QTest::newRow("stretch") << true;
}

/// The order must know of the anchors: one made for the mesh alone takes four times the operations here.
void NormalMatrixTest::manyAnchorsCostLittle() {
  const MapFrame frame = *MapFrame::create(0.1, 400, 400, {{0.0, 0.0}, 0.0});
  const auto mesh = testing::meshOf(testing::drawGrid(frame, [](int, int) { return true; }), 1.0);
  const auto operationsWith = [&](std::size_t count) {
    const AnchorList anchors = testing::anchorsAt(*mesh, count, 5, [](const Vector2d& p) { return p; });
    const SolverSettings settings = withAutomaticWeights(defaultSettings(Model::kStretch), *mesh, 1.0);
    NormalMatrix normal;
    return normal.analyse(buildObjective(*mesh, anchors, settings, {})) ? normal.operations() : 0.0;
  };
  const double few = operationsWith(3);
  QVERIFY(few > 0.0);
  QVERIFY(operationsWith(100) < 1.6 * few);
}

void NormalMatrixTest::solvesLikeADenseMatrix() {
  QFETCH(bool, stretch);
  const Case made = makeCase(stretch);
  NormalMatrix normal;
  QVERIFY(!normal.hasFactorFor(made.objective));
  QVERIFY(normal.analyse(made.objective));
  QVERIFY(normal.factorise(made.objective, made.x.data(), 0.0));
  QVERIFY(normal.hasFactorFor(made.objective));
  const MatrixXd dense = denseNormalMatrix(made);
  const VectorXd right = VectorXd::LinSpaced(dense.rows(), -1.0, 2.0);
  VectorXd solution;
  QVERIFY(normal.solve(right, solution));
  QVERIFY((dense * solution - right).norm() < 1e-8 * right.norm());
}

void NormalMatrixTest::dampingScalesTheDiagonal() {
  const Case made = makeCase(true);
  NormalMatrix normal;
  QVERIFY(normal.analyse(made.objective));
  QVERIFY(normal.factorise(made.objective, made.x.data(), 0.3));
  MatrixXd dense = denseNormalMatrix(made);
  dense.diagonal() *= 1.3;
  const VectorXd right = VectorXd::LinSpaced(dense.rows(), -1.0, 2.0);
  VectorXd solution;
  QVERIFY(normal.solve(right, solution));
  QVERIFY((dense * solution - right).norm() < 1e-8 * right.norm());
}

void NormalMatrixTest::inverseFormIsThatOfADenseMatrix() {
  QFETCH(bool, stretch);
  const Case made = makeCase(stretch);
  NormalMatrix normal;
  QVERIFY(normal.analyse(made.objective));
  QVERIFY(normal.factorise(made.objective, made.x.data(), 0.0));
  const MatrixXd inverse = denseNormalMatrix(made).inverse();
  std::mt19937 random(9);
  std::uniform_int_distribution<std::size_t> row(0, made.objective.size() - 1);
  for (int round = 0; round < 20; ++round) {
    NormalMatrix::SparseColumns columns;
    MatrixXd dense = MatrixXd::Zero(inverse.rows(), 4);
    for (int k = 0; k < 6; ++k) {
      columns.rows.push_back(row(random));
      columns.values.emplace_back(Eigen::Vector4d::Random());
      dense.row(static_cast<Eigen::Index>(columns.rows.back())) += columns.values.back().transpose();
    }
    const Eigen::Matrix4d expected = dense.transpose() * inverse * dense;
    QVERIFY((normal.inverseForms({columns}).front() - expected).norm() < 1e-8 * expected.norm());
  }
}

void NormalMatrixTest::followsAChangeOfAnchors() {
  NormalMatrix normal;
  for (const std::size_t anchors : {9, 4, 12}) {
    const Case made = makeCase(true, anchors);
    QVERIFY(normal.analyse(made.objective));
    QVERIFY(normal.factorise(made.objective, made.x.data(), 0.0));
    const MatrixXd dense = denseNormalMatrix(made);
    const VectorXd right = VectorXd::Ones(dense.rows());
    VectorXd solution;
    QVERIFY(normal.solve(right, solution));
    QVERIFY((dense * solution - right).norm() < 1e-8 * right.norm());
  }
}

/// The factor of nine anchors stands in for that of ten and eleven, but not of more.
void NormalMatrixTest::aFactorFollowsAFewAnchors() {
  const Case made = makeCase(true, 16);
  const auto with = [&](std::size_t first, std::size_t last) {
    Case some = made;
    const auto& all = made.objective.anchors;
    some.objective.anchors.assign(all.begin() + static_cast<std::ptrdiff_t>(first),
                                  all.begin() + static_cast<std::ptrdiff_t>(last));
    return some;
  };
  NormalMatrix normal;
  QVERIFY(!normal.adaptFactor(made.objective, made.x.data()));
  QVERIFY(normal.analyse(with(2, 12).objective));
  QVERIFY(normal.factorise(with(2, 12).objective, made.x.data(), 0.0));
  // None changed; new ones; gone ones; both.
  using Range = std::pair<std::size_t, std::size_t>;
  for (const auto& [first, last] : {Range{2, 12}, {2, 16}, {2, 8}, {4, 14}}) {
    const Case other = with(first, last);
    QVERIFY(normal.analyse(other.objective));  // for the next factorisation: the factor stays
    QVERIFY(normal.adaptFactor(other.objective, other.x.data()));
    const MatrixXd dense = denseNormalMatrix(other);
    const VectorXd right = VectorXd::LinSpaced(dense.rows(), -1.0, 2.0);
    VectorXd solution;
    QVERIFY(normal.solve(right, solution));
    QVERIFY((dense * solution - right).norm() < 1e-6 * right.norm());
  }
  for (const auto& [first, last] : {Range{0, 15}, {2, 7}, {5, 14}}) {
    QVERIFY(!normal.adaptFactor(with(first, last).objective, made.x.data()));
  }
  Case other_nodes = with(2, 12);
  std::swap(other_nodes.objective.active_nodes[0], other_nodes.objective.active_nodes[1]);
  QVERIFY(!normal.adaptFactor(other_nodes.objective, made.x.data()));
  normal.forgetFactor();
  QVERIFY(!normal.adaptFactor(with(2, 12).objective, made.x.data()));
}

/// Without the anchors that alone hold the mesh there is nothing to solve with: the factor must not pretend there is.
void NormalMatrixTest::aFactorKeepsWhatHoldsTheMesh() {
  Case made = makeCase(true, 2);
  made.objective.heading_prior.clear();
  NormalMatrix normal;
  QVERIFY(normal.analyse(made.objective));
  QVERIFY(normal.factorise(made.objective, made.x.data(), 0.0));
  made.objective.anchors.clear();
  QVERIFY(!normal.adaptFactor(made.objective, made.x.data()));
}

/// On meshes of thousands of nodes another thread makes it.
void NormalMatrixTest::theNextLayoutComesWhileTheFactorServes() {
  const MapFrame frame = *MapFrame::create(0.1, 500, 500, {{0.0, 0.0}, 0.0});
  const auto mesh = testing::meshOf(testing::drawGrid(frame, [](int, int) { return true; }), 1.0);
  const SolverSettings settings = withAutomaticWeights(defaultSettings(Model::kStretch), *mesh, 1.0);
  const AnchorList anchors = testing::anchorsAt(*mesh, 20, 5, [](const Vector2d& p) { return p; });
  const Objective after = buildObjective(*mesh, anchors, settings, {});
  Objective before = after;
  before.anchors.pop_back();
  const VectorXd x = startingPoint(before, *mesh, {}, nullptr);
  const VectorXd right = VectorXd::LinSpaced(x.size(), -1.0, 2.0);
  NormalMatrix fresh;
  VectorXd expected;
  QVERIFY(fresh.analyse(after) && fresh.factorise(after, x.data(), 0.0) && fresh.solve(right, expected));

  NormalMatrix normal;
  QVERIFY(normal.analyse(before) && normal.factorise(before, x.data(), 0.0));
  QVERIFY(normal.analyse(after));
  QVERIFY(normal.adaptFactor(after, x.data()));
  VectorXd solution;
  QVERIFY(normal.solve(right, solution));
  QVERIFY((solution - expected).norm() < 1e-6 * expected.norm());
  QVERIFY(!normal.isOutOfMemory());
  QVERIFY(normal.factorise(after, x.data(), 0.0) && normal.solve(right, solution));
  QVERIFY((solution - expected).norm() < 1e-12 * expected.norm());
  // One that nobody waits for is not lost.
  QVERIFY(normal.analyse(before));
}

void NormalMatrixTest::knowsWhatItCanNotFactorise() {
  Case made = makeCase(false);
  NormalMatrix normal;
  QVERIFY(normal.analyse(made.objective));
  // Nothing holds the nodes any more.
  made.objective.anchors.clear();
  made.objective.sqrt_lambda_theta = 0.0;
  for (EdgeTerm& edge : made.objective.edges) edge.whitener.setZero();
  QVERIFY(!normal.factorise(made.objective, made.x.data(), 0.0));
  QVERIFY(!normal.hasFactorFor(made.objective));
}

}  // namespace cad2slam

QTEST_GUILESS_MAIN(cad2slam::NormalMatrixTest)
#include "normal_matrix_test.moc"
