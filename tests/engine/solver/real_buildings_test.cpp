// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include <QtTest>

#include <random>

#include "cad2slam/solver/mesh_solver.h"
#include "support/paper_data.h"
#include "support/synthetic_buildings.h"

/// The buildings of the paper. Numbers of the rigid model are final: the model is the paper's.
namespace cad2slam {
namespace {

struct Numbers {
  double cost = 0.0;
  double mean_residual_m = 0.0;
  double mean_leave_one_out_m = 0.0;
};

Numbers numbersOf(const Solution& solution) {
  Numbers numbers{solution.cost, 0.0, 0.0};
  const auto count = static_cast<double>(solution.anchors.size());
  for (const AnchorFit& fit : solution.anchors) {
    numbers.mean_residual_m += fit.residual_m / count;
    numbers.mean_leave_one_out_m += fit.leave_one_out_m / count;
  }
  return numbers;
}

bool near(double found, double expected, double part) {
  return std::abs(found - expected) <= part * expected;
}

}  // namespace

class RealBuildingsTest : public QObject {
  Q_OBJECT
 private slots:
  void rigid_data();
  void rigid();
  void leaveOneOutEqualsSolvingWithout_data() { rigid_data(); }
  void leaveOneOutEqualsSolvingWithout();
  void stretchBeatsRigid_data() { rigid_data(); }
  void stretchBeatsRigid();
  void rigidHasNoBetterMinimumNearby_data() { rigid_data(); }
  void rigidHasNoBetterMinimumNearby();
  void backendsAgree();
};

void RealBuildingsTest::rigid_data() {
  QTest::addColumn<QString>("site");
  QTest::addColumn<double>("cost");
  QTest::addColumn<double>("residual_m");
  QTest::addColumn<double>("leave_one_out_m");
  QTest::newRow("DEMO") << "demo" << 27.8676852 << 0.05741 << 0.30076;
  QTest::newRow("DIAG") << "diag" << 68.6511468 << 0.06710 << 0.54553;
  QTest::newRow("EIII-0") << "eiii-0" << 14.3082035 << 0.05234 << 0.20479;
}

void RealBuildingsTest::rigid() {
  QFETCH(QString, site);
  QFETCH(double, cost);
  QFETCH(double, residual_m);
  QFETCH(double, leave_one_out_m);
  CAD2SLAM_SKIP_WITHOUT_PAPER_SITE(site);
  const Result<testing::PaperSite> data = testing::loadPaperSite(site);
  QVERIFY(data.has_value());
  const auto mesh = testing::meshOf(data->blueprint.grid, data->cell_size_m);
  const Result<Solution> solution = MeshSolver(mesh).solve(data->anchors, defaultSettings(Model::kRigid));
  QVERIFY(solution.has_value());
  QVERIFY(solution->converged);
  QVERIFY(solution->relative_gradient < 1e-8);
  const Numbers numbers = numbersOf(*solution);
  qDebug("cost %.9g, residual %.5f m, leave one out %.5f m", numbers.cost, numbers.mean_residual_m,
         numbers.mean_leave_one_out_m);
  QVERIFY(near(numbers.cost, cost, 1e-6));
  QVERIFY(near(numbers.mean_residual_m, residual_m, 1e-3));
  QVERIFY(near(numbers.mean_leave_one_out_m, leave_one_out_m, 1e-3));
}

void RealBuildingsTest::leaveOneOutEqualsSolvingWithout() {
  QFETCH(QString, site);
  CAD2SLAM_SKIP_WITHOUT_PAPER_SITE(site);
  Result<testing::PaperSite> data = testing::loadPaperSite(site);
  QVERIFY(data.has_value());
  const auto mesh = testing::meshOf(data->blueprint.grid, data->cell_size_m);
  MeshSolver solver(mesh);
  const Solution all = *solver.solve(data->anchors, defaultSettings(Model::kRigid));
  double found_m = 0.0;
  double expected_m = 0.0;
  for (std::size_t k = 0; k < data->anchors.size(); k += 5) {
    data->anchors[k].enabled = false;
    const Solution without = *solver.solve(data->anchors, defaultSettings(Model::kRigid), &all);
    data->anchors[k].enabled = true;
    found_m += all.anchors[k].leave_one_out_m;
    expected_m += without.anchors[k].residual_m;
  }
  QVERIFY2(near(found_m, expected_m, 0.1), qPrintable(QString("%1 m, solved %2 m").arg(found_m).arg(expected_m)));
}

void RealBuildingsTest::stretchBeatsRigid() {
  QFETCH(QString, site);
  CAD2SLAM_SKIP_WITHOUT_PAPER_SITE(site);
  const Result<testing::PaperSite> data = testing::loadPaperSite(site);
  QVERIFY(data.has_value());
  const auto mesh = testing::meshOf(data->blueprint.grid, data->cell_size_m);
  MeshSolver solver(mesh);
  const Result<Solution> rigid = solver.solve(data->anchors, defaultSettings(Model::kRigid));
  const Result<Solution> stretch = solver.solve(data->anchors, defaultSettings(Model::kStretch));
  QVERIFY(rigid.has_value() && stretch.has_value());
  QVERIFY(stretch->converged);
  QVERIFY(stretch->relative_gradient < 1e-8);
  const double rigid_m = numbersOf(*rigid).mean_leave_one_out_m;
  const double stretch_m = numbersOf(*stretch).mean_leave_one_out_m;
  QVERIFY2(stretch_m < 0.95 * rigid_m, qPrintable(QString("%1 m, rigid %2 m").arg(stretch_m).arg(rigid_m)));
}

void RealBuildingsTest::rigidHasNoBetterMinimumNearby() {
  QFETCH(QString, site);
  CAD2SLAM_SKIP_WITHOUT_PAPER_SITE(site);
  const Result<testing::PaperSite> data = testing::loadPaperSite(site);
  QVERIFY(data.has_value());
  const auto mesh = testing::meshOf(data->blueprint.grid, data->cell_size_m);
  MeshSolver solver(mesh);
  const Solution best = *solver.solve(data->anchors, defaultSettings(Model::kRigid));
  std::mt19937 random(5);
  std::normal_distribution<double> noise(0.0, 1.0);
  for (int start = 0; start < 20; ++start) {
    Solution from = best;
    const double amount = 0.1 * (start + 1);
    for (Pose2& pose : from.node_slam) {
      pose.translation += amount * Eigen::Vector2d(noise(random), noise(random));
      pose.heading += 0.3 * amount * noise(random);
    }
    const Result<Solution> found = solver.solve(data->anchors, defaultSettings(Model::kRigid), &from);
    if (found) QVERIFY(found->cost >= best.cost * (1.0 - 1e-9));
  }
}

void RealBuildingsTest::backendsAgree() {
  CAD2SLAM_SKIP_WITHOUT_PAPER_SITE("eiii-0");
  const Result<testing::PaperSite> data = testing::loadPaperSite("eiii-0");
  QVERIFY(data.has_value());
  const auto mesh = testing::meshOf(data->blueprint.grid, data->cell_size_m);
  for (const Model model : {Model::kRigid, Model::kStretch}) {
    const Solution direct = *MeshSolver(mesh).solve(data->anchors, defaultSettings(model));
    const Solution ceres = *MeshSolver(mesh, SolverBackend::kCeres).solve(data->anchors, defaultSettings(model));
    QVERIFY(near(direct.cost, ceres.cost, 1e-9));
    for (std::size_t node = 0; node < mesh->nodeCount(); ++node) {
      QVERIFY((direct.node_slam[node].translation - ceres.node_slam[node].translation).norm() < 1e-5);
    }
  }
}

}  // namespace cad2slam

QTEST_GUILESS_MAIN(cad2slam::RealBuildingsTest)
#include "real_buildings_test.moc"
