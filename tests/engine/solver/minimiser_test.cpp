// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/solver/minimiser.h"

#include <QtTest>

#include <limits>
#include <random>

#include "cad2slam/solver/build_objective.h"
#include "cad2slam/solver/ceres_backend.h"
#include "support/synthetic_buildings.h"

namespace cad2slam {
namespace {

using Eigen::Vector2d;
using Eigen::VectorXd;

struct Case {
  std::shared_ptr<const Mesh> mesh;
  Objective objective;
  VectorXd start;
  MinimiserOptions options;
};

Case makeCase(Model model) {
  Case made;
  made.mesh = testing::meshOf(testing::uShapedCorridor(), 1.0);
  const Similarity2 fit{1.0, 0.3, {0.0, 0.0}};
  const AnchorList anchors = testing::anchorsAt(*made.mesh, 12, 5, [&](const Vector2d& p) -> Vector2d {
    return fit * p + Vector2d(std::sin(0.3 * p.y()), 0.5 * std::cos(0.3 * p.x()));
  });
  made.objective =
      buildObjective(*made.mesh, anchors, withAutomaticWeights(defaultSettings(model), *made.mesh, 1.0), fit);
  made.start = startingPoint(made.objective, *made.mesh, fit, nullptr);
  VectorXd gradient(made.start.size());
  (void)gradientAt(made.objective, made.start.data(), gradient.data());
  made.options.gradient_at_start = gradient.lpNorm<Eigen::Infinity>();
  return made;
}

MinimiserReport run(const Case& made, VectorXd& x, const IterationCallback& on_iteration = {}) {
  NormalMatrix normal;
  return normal.analyse(made.objective) ? minimise(made.objective, x, normal, made.options, on_iteration)
                                        : MinimiserReport{};
}

}  // namespace

class MinimiserTest : public QObject {
  Q_OBJECT
 private slots:
  void endsWhereTheGradientVanishes_data() { models(); }
  void endsWhereTheGradientVanishes();
  void agreesWithCeres_data() { models(); }
  void agreesWithCeres();
  void anOldFactorIsAGoodStart();
  void survivesWildStarts();
  void stopsWhenTold();
  void brokenNumbersAreReported();

 private:
  static void models();
};

void MinimiserTest::models() {
  QTest::addColumn<Model>("model");
  QTest::newRow("rigid") << Model::kRigid;
  QTest::newRow("stretch") << Model::kStretch;
}

void MinimiserTest::endsWhereTheGradientVanishes() {
  QFETCH(Model, model);
  const Case made = makeCase(model);
  VectorXd x = made.start;
  const MinimiserReport report = run(made, x);
  QVERIFY(report.converged && report.finite && !report.cancelled);
  VectorXd gradient(x.size());
  QCOMPARE(gradientAt(made.objective, x.data(), gradient.data()), report.cost);
  QVERIFY(gradient.lpNorm<Eigen::Infinity>() <= 1e-9 * made.options.gradient_at_start);
  // Any step from there costs more.
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0.0, 1e-3);
  for (int round = 0; round < 50; ++round) {
    VectorXd beside = x;
    for (double& unknown : beside) unknown += noise(random);
    QVERIFY(costAt(made.objective, beside.data()) > report.cost);
  }
}

void MinimiserTest::agreesWithCeres() {
  QFETCH(Model, model);
  const Case made = makeCase(model);
  VectorXd ours = made.start;
  VectorXd theirs = made.start;
  const MinimiserReport report = run(made, ours);
  const MinimiserReport reference = minimiseWithCeres(made.objective, theirs, made.options, {});
  QVERIFY(reference.converged);
  QVERIFY(std::abs(report.cost - reference.cost) < 1e-10 * reference.cost);
  QVERIFY((ours - theirs).lpNorm<Eigen::Infinity>() < 1e-6);
}

void MinimiserTest::anOldFactorIsAGoodStart() {
  const Case made = makeCase(Model::kStretch);
  NormalMatrix normal;
  QVERIFY(normal.analyse(made.objective));
  VectorXd first = made.start;
  QVERIFY(minimise(made.objective, first, normal, made.options, {}).converged);
  VectorXd again = made.start;
  QVERIFY(minimise(made.objective, again, normal, made.options, {}).converged);
  QVERIFY((first - again).lpNorm<Eigen::Infinity>() < 1e-6);
}

void MinimiserTest::survivesWildStarts() {
  const Case made = makeCase(Model::kStretch);
  VectorXd best = made.start;
  const double cost = run(made, best).cost;
  std::mt19937 random(4);
  std::normal_distribution<double> noise(0.0, 2.0);
  for (int round = 0; round < 10; ++round) {
    VectorXd x = made.start;
    for (double& unknown : x) unknown += noise(random);
    const MinimiserReport report = run(made, x);
    QVERIFY(report.finite);
    QVERIFY(report.cost >= cost * (1.0 - 1e-9));
    QVERIFY(report.cost <= costAt(made.objective, made.start.data()) * 1e6);
  }
}

void MinimiserTest::stopsWhenTold() {
  const Case made = makeCase(Model::kStretch);
  VectorXd x = made.start;
  int calls = 0;
  const MinimiserReport report = run(made, x, [&](const IterationReport& at) {
    ++calls;
    return at.iteration >= 2 ? NextStep::kStop : NextStep::kContinue;
  });
  QVERIFY(report.cancelled && !report.converged);
  QCOMPARE(calls, 2);
  QCOMPARE(report.iterations, 2);
  QVERIFY(report.cost < costAt(made.objective, made.start.data()));
}

void MinimiserTest::brokenNumbersAreReported() {
  const Case made = makeCase(Model::kStretch);
  VectorXd x = made.start;
  x[7] = std::numeric_limits<double>::quiet_NaN();
  const MinimiserReport report = run(made, x);
  QVERIFY(!report.finite && !report.converged);
}

}  // namespace cad2slam

QTEST_GUILESS_MAIN(cad2slam::MinimiserTest)
#include "minimiser_test.moc"
