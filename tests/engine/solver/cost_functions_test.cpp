// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/solver/cost_functions.h"

#include <ceres/gradient_checker.h>

#include <QtTest>

#include <random>

#include "cad2slam/solver/build_objective.h"
#include "support/synthetic_buildings.h"

namespace cad2slam {
namespace {

/// An objective over a corridor with every kind of term, heading priors too.
Objective makeObjective(Model model, const Mesh& mesh) {
  AnchorList anchors = testing::anchorsAt(mesh, 6, 8, [](const Eigen::Vector2d& p) -> Eigen::Vector2d {
    return rotationMatrix(-2.2) * p + Eigen::Vector2d(1.0, 0.1 * p.x());
  });
  const Similarity2 fit{1.05, -2.2, {1.0, 0.0}};
  Objective objective =
      buildObjective(mesh, anchors, withAutomaticWeights(defaultSettings(model), mesh, fit.scale), fit);
  objective.heading_prior.assign(objective.nodeCount(), 0.7);
  return objective;
}

std::vector<std::vector<double>> randomNodes(std::size_t count, int unknowns, std::mt19937& random) {
  std::normal_distribution<double> part(0.0, 0.5);
  std::vector<std::vector<double>> nodes(count, std::vector<double>(static_cast<std::size_t>(unknowns)));
  for (std::vector<double>& node : nodes) {
    for (double& unknown : node) unknown = part(random);
    node[2] += 3.0;  // on both sides of pi; more would lengthen the checker's relative steps beyond half a turn
  }
  return nodes;
}

double largestError(const ceres::CostFunction& cost, const std::vector<std::vector<double>>& nodes) {
  std::vector<const double*> blocks;
  for (const std::vector<double>& node : nodes) blocks.push_back(node.data());
  // Ceres 2.1 has two constructors that take a bare nullptr.
  const std::vector<const ceres::Manifold*>* no_manifolds = nullptr;
  const ceres::GradientChecker checker(&cost, no_manifolds, ceres::NumericDiffOptions());
  ceres::GradientChecker::ProbeResults results;
  checker.Probe(blocks.data(), 1e-9, &results);
  return results.return_value ? results.maximum_relative_error : 1.0;
}

}  // namespace

class CostFunctionsTest : public QObject {
  Q_OBJECT
 private slots:
  void jacobiansAgreeWithDifferences_data() { models(); }
  void jacobiansAgreeWithDifferences();
  void residualsSumUpToTheCost_data() { models(); }
  void residualsSumUpToTheCost();

 private:
  static void models();
};

void CostFunctionsTest::models() {
  QTest::addColumn<bool>("stretch");
  QTest::newRow("rigid") << false;
  QTest::newRow("stretch") << true;
}

void CostFunctionsTest::jacobiansAgreeWithDifferences() {
  QFETCH(bool, stretch);
  const auto mesh = testing::meshOf(testing::uShapedCorridor(), 2.0);
  const Objective objective = makeObjective(stretch ? Model::kStretch : Model::kRigid, *mesh);
  std::mt19937 random(11);
  for (int round = 0; round < 20; ++round) {
    const EdgeTerm& edge = objective.edges[static_cast<std::size_t>(round) % objective.edges.size()];
    QVERIFY(largestError(*makeEdgeCost(objective, edge), randomNodes(2, objective.unknowns, random)) < 1e-7);
    QVERIFY(largestError(*makeNodeCost(objective, 3), randomNodes(1, objective.unknowns, random)) < 1e-7);
    const AnchorTerm& anchor = objective.anchors[static_cast<std::size_t>(round) % objective.anchors.size()];
    QVERIFY(largestError(*makeAnchorCost(objective, anchor),
                         randomNodes(anchor.blend.count, objective.unknowns, random)) < 1e-7);
  }
}

/// The sum over all cost functions is the objective, so that both backends minimise the same function.
void CostFunctionsTest::residualsSumUpToTheCost() {
  QFETCH(bool, stretch);
  const auto mesh = testing::meshOf(testing::uShapedCorridor(), 2.0);
  Objective objective = makeObjective(stretch ? Model::kStretch : Model::kRigid, *mesh);
  objective.loss_width_m = 0.0;
  std::mt19937 random(12);
  const std::vector<std::vector<double>> nodes = randomNodes(objective.nodeCount(), objective.unknowns, random);
  double cost = 0.0;
  const auto add = [&](const ceres::CostFunction& function, const std::vector<const double*>& blocks) {
    Eigen::VectorXd residuals(function.num_residuals());
    QVERIFY(function.Evaluate(blocks.data(), residuals.data(), nullptr));
    cost += 0.5 * residuals.squaredNorm();
  };
  for (const EdgeTerm& edge : objective.edges) {
    add(*makeEdgeCost(objective, edge), {nodes[edge.from].data(), nodes[edge.to].data()});
  }
  for (std::size_t node = 0; node < objective.nodeCount(); ++node) {
    add(*makeNodeCost(objective, node), {nodes[node].data()});
  }
  for (const AnchorTerm& anchor : objective.anchors) {
    std::vector<const double*> blocks;
    for (std::size_t k = 0; k < anchor.blend.count; ++k) blocks.push_back(nodes[anchor.blend.nodes[k]].data());
    add(*makeAnchorCost(objective, anchor), blocks);
  }
  std::vector<double> x;
  for (const std::vector<double>& node : nodes) x.insert(x.end(), node.begin(), node.end());
  QVERIFY(std::abs(cost - costAt(objective, x.data())) < 1e-12 * cost);
}

}  // namespace cad2slam

QTEST_GUILESS_MAIN(cad2slam::CostFunctionsTest)
#include "cost_functions_test.moc"
