// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/solver/mesh_solver.h"

#include <QtTest>

#include <cstring>
#include <random>

#include "support/synthetic_buildings.h"

namespace cad2slam {
namespace {

using Eigen::Vector2d;

/// A bend by some metres and a turn by almost half a circle.
Vector2d bend(const Vector2d& p) {
  const Vector2d turned = rotationMatrix(2.9) * p;
  return {1.03 * turned.x() + 0.8 * std::sin(0.2 * p.y()), turned.y() + 0.9 * std::cos(0.15 * p.x())};
}

std::shared_ptr<const Mesh> corridor() {
  return testing::meshOf(testing::uShapedCorridor(), 1.0);
}

/// Largest distances between the poses of two solutions [m], [rad].
std::pair<double, double> apart(const Solution& a, const Solution& b) {
  double metres = 0.0;
  double radians = 0.0;
  for (std::size_t node = 0; node < a.node_slam.size(); ++node) {
    metres = std::max(metres, (a.node_slam[node].translation - b.node_slam[node].translation).norm());
    radians = std::max(radians, std::abs(wrapAngle(a.node_slam[node].heading - b.node_slam[node].heading)));
  }
  return {metres, radians};
}

bool sameBits(const Solution& a, const Solution& b) {
  const auto same = [](double left, double right) { return std::memcmp(&left, &right, sizeof left) == 0; };
  bool all = a.node_slam.size() == b.node_slam.size() && same(a.cost, b.cost) && a.iterations == b.iterations;
  for (std::size_t node = 0; all && node < a.node_slam.size(); ++node) {
    all = same(a.node_slam[node].translation.x(), b.node_slam[node].translation.x()) &&
          same(a.node_slam[node].translation.y(), b.node_slam[node].translation.y()) &&
          same(a.node_slam[node].heading, b.node_slam[node].heading) &&
          same(a.node_stretch[node].x(), b.node_stretch[node].x()) &&
          same(a.node_stretch[node].y(), b.node_stretch[node].y());
  }
  for (std::size_t k = 0; all && k < a.anchors.size(); ++k) {
    all = same(a.anchors[k].leave_one_out_m, b.anchors[k].leave_one_out_m);
  }
  return all;
}

}  // namespace

class MeshSolverTest : public QObject {
  Q_OBJECT
 private slots:
  void rigidMotionsAreExact_data() { models(); }
  void rigidMotionsAreExact();
  void similaritiesAreExact_data() { models(); }
  void similaritiesAreExact();
  void startsFromAnyRotation_data() { models(); }
  void startsFromAnyRotation();
  void backendsAgree_data() { models(); }
  void backendsAgree();
  void warmStartEqualsColdStart_data() { models(); }
  void warmStartEqualsColdStart();
  void twoRunsAreBitIdentical_data() { models(); }
  void twoRunsAreBitIdentical();
  void coldSolvesKnowNothingOfEarlierOnes_data() { models(); }
  void coldSolvesKnowNothingOfEarlierOnes();
  void noOtherStartIsBetter_data() { models(); }
  void noOtherStartIsBetter();
  void reportsProgressAndCanBeCancelled_data();
  void reportsProgressAndCanBeCancelled();
  void sayWhenTheyDidNotConverge();
  void partsWithoutAnchorsFollowTheGlobalFit_data() { models(); }
  void partsWithoutAnchorsFollowTheGlobalFit();
  void partsWithFewAnchorsAreHeld_data() { models(); }
  void partsWithFewAnchorsAreHeld();

 private:
  static void models();
};

void MeshSolverTest::models() {
  QTest::addColumn<Model>("model");
  QTest::newRow("rigid") << Model::kRigid;
  QTest::newRow("stretch") << Model::kStretch;
}

void MeshSolverTest::rigidMotionsAreExact() {
  QFETCH(Model, model);
  const auto mesh = corridor();
  MeshSolver solver(mesh);
  for (double heading = -kPi; heading < kPi; heading += 0.37) {
    const Pose2 truth{{-40.0, 13.0}, heading};
    const AnchorList anchors = testing::anchorsAt(*mesh, 12, 2, [&](const Vector2d& p) { return truth * p; });
    const Result<Solution> solution = solver.solve(anchors, defaultSettings(model));
    QVERIFY(solution.has_value());
    QVERIFY(solution->converged);
    QVERIFY(solution->cost < 1e-16);
    for (std::size_t node = 0; node < mesh->nodeCount(); ++node) {
      QVERIFY((solution->node_slam[node].translation - truth * mesh->centers()[node]).norm() < 1e-8);
      QVERIFY(std::abs(wrapAngle(solution->node_slam[node].heading - heading)) < 1e-8);
      QVERIFY(solution->node_stretch[node].norm() < 1e-8);
    }
    for (const AnchorFit& fit : solution->anchors) QVERIFY(fit.leave_one_out_m < 1e-8);
  }
}

void MeshSolverTest::similaritiesAreExact() {
  QFETCH(Model, model);
  const auto mesh = corridor();
  for (const double scale : {0.4, 0.99, 1.37, 20.0}) {
    const Similarity2 truth{scale, -2.4, {5.0, 80.0}};
    const AnchorList anchors = testing::anchorsAt(*mesh, 12, 2, [&](const Vector2d& p) { return truth * p; });
    for (const ScaleSettings& rule : {ScaleSettings{ScaleRule::kLeastSquares, 1.0}, {ScaleRule::kFixed, scale}}) {
      SolverSettings settings = defaultSettings(model);
      settings.scale = rule;
      const Result<Solution> solution = MeshSolver(mesh).solve(anchors, settings);
      QVERIFY(solution.has_value());
      QVERIFY(std::abs(solution->global_fit.scale - scale) < 1e-10);
      for (std::size_t node = 0; node < mesh->nodeCount(); ++node) {
        QVERIFY((solution->node_slam[node].translation - truth * mesh->centers()[node]).norm() < 1e-7);
        QVERIFY(solution->node_stretch[node].norm() < 1e-8);
      }
    }
  }
}

void MeshSolverTest::startsFromAnyRotation() {
  QFETCH(Model, model);
  const auto mesh = corridor();
  const AnchorList anchors = testing::anchorsAt(*mesh, 20, 2, bend);
  const Solution expected = *MeshSolver(mesh).solve(anchors, defaultSettings(model));
  for (const double heading : {-3.1, -1.6, 0.2, 1.5, 3.0}) {
    const Pose2 turn{{100.0, -20.0}, heading};
    AnchorList turned = anchors;
    for (Anchor& anchor : turned) anchor.in_slam = turn * anchor.in_slam;
    const Result<Solution> solution = MeshSolver(mesh).solve(turned, defaultSettings(model));
    QVERIFY(solution.has_value());
    QVERIFY(std::abs(solution->cost - expected.cost) < 1e-8 * expected.cost);
    for (std::size_t node = 0; node < mesh->nodeCount(); ++node) {
      const Vector2d place = turn * expected.node_slam[node].translation;
      QVERIFY((solution->node_slam[node].translation - place).norm() < 1e-5);
    }
  }
}

void MeshSolverTest::backendsAgree() {
  QFETCH(Model, model);
  const auto mesh = corridor();
  AnchorList anchors = testing::anchorsAt(*mesh, 20, 2, bend);
  const Vector2d place(-1.2, 9.4);
  anchors.push_back({99, place, bend(place) + Vector2d(3.0, -2.0), true, {}, {}});  // so that the loss is at work
  const Result<Solution> direct = MeshSolver(mesh).solve(anchors, defaultSettings(model));
  const Result<Solution> ceres = MeshSolver(mesh, SolverBackend::kCeres).solve(anchors, defaultSettings(model));
  QVERIFY2(direct, direct ? "" : direct.error().sentence().c_str());
  QVERIFY2(ceres, ceres ? "" : ceres.error().sentence().c_str());
  QVERIFY(direct->converged && ceres->converged);
  QVERIFY(direct->relative_gradient < 1e-8);
  QVERIFY(ceres->relative_gradient < 1e-8);
  QVERIFY(std::abs(direct->cost - ceres->cost) < 1e-9 * ceres->cost);
  const auto [metres, radians] = apart(*direct, *ceres);
  QVERIFY(metres < 1e-5);
  QVERIFY(radians < 1e-5);
  for (std::size_t k = 0; k < anchors.size(); ++k) {
    QVERIFY(std::abs(direct->anchors[k].leave_one_out_m - ceres->anchors[k].leave_one_out_m) < 1e-5);
  }
}

void MeshSolverTest::warmStartEqualsColdStart() {
  QFETCH(Model, model);
  const auto mesh = corridor();
  AnchorList anchors = testing::anchorsAt(*mesh, 20, 2, bend);
  MeshSolver solver(mesh);
  Solution last = *solver.solve(anchors, defaultSettings(model));
  // The edits of an installer: drag, switch off, delete, add.
  for (int edit = 0; edit < 4; ++edit) {
    if (edit == 0) anchors[4].in_slam += Vector2d(0.4, -0.3);
    if (edit == 1) anchors[9].enabled = false;
    if (edit == 2) anchors.erase(anchors.begin() + 2);
    if (edit == 3) anchors.push_back({99, {-2.5, 13.0}, bend({-2.5, 13.0}), true, {}, {}});
    const Result<Solution> warm = solver.solve(anchors, defaultSettings(model), &last);
    const Result<Solution> cold = MeshSolver(mesh).solve(anchors, defaultSettings(model));
    QVERIFY(warm.has_value() && cold.has_value());
    QVERIFY(warm->converged && cold->converged);
    QVERIFY(std::abs(warm->cost - cold->cost) < 1e-8 * cold->cost);
    const auto [metres, radians] = apart(*warm, *cold);
    QVERIFY(metres < 1e-5);
    QVERIFY(radians < 1e-5);
    last = *warm;
  }
  // A warm start that does not fit the mesh or the model is no start, but no failure either.
  Solution other = last;
  other.settings.model = model == Model::kRigid ? Model::kStretch : Model::kRigid;
  QVERIFY(std::abs(solver.solve(anchors, defaultSettings(model), &other)->cost - last.cost) < 1e-8 * last.cost);
  other = last;
  other.node_slam.pop_back();
  QVERIFY(std::abs(solver.solve(anchors, defaultSettings(model), &other)->cost - last.cost) < 1e-8 * last.cost);
}

void MeshSolverTest::twoRunsAreBitIdentical() {
  QFETCH(Model, model);
  const auto mesh = corridor();
  const AnchorList anchors = testing::anchorsAt(*mesh, 20, 2, bend);
  const Result<Solution> first = MeshSolver(mesh).solve(anchors, defaultSettings(model));
  const Result<Solution> second = MeshSolver(corridor()).solve(anchors, defaultSettings(model));
  QVERIFY(first.has_value() && second.has_value());
  QVERIFY(sameBits(*first, *second));
}

void MeshSolverTest::coldSolvesKnowNothingOfEarlierOnes() {
  QFETCH(Model, model);
  const auto mesh = corridor();
  AnchorList anchors = testing::anchorsAt(*mesh, 20, 2, bend);
  MeshSolver used(mesh);
  for (Anchor& anchor : anchors) {  // one left out after the other, as an evaluation does
    anchor.enabled = false;
    const Result<Solution> after_others = used.solve(anchors, defaultSettings(model));
    const Result<Solution> fresh = MeshSolver(mesh).solve(anchors, defaultSettings(model));
    anchor.enabled = true;
    QVERIFY(after_others.has_value() && fresh.has_value());
    QVERIFY(sameBits(*after_others, *fresh));
  }
}

void MeshSolverTest::noOtherStartIsBetter() {
  QFETCH(Model, model);
  const auto mesh = corridor();
  const AnchorList anchors = testing::anchorsAt(*mesh, 20, 2, bend);
  const Solution best = *MeshSolver(mesh).solve(anchors, defaultSettings(model));
  std::mt19937 random(77);
  std::normal_distribution<double> noise(0.0, 1.0);
  std::uniform_real_distribution<double> turn(-kPi, kPi);
  int same = 0;
  for (int start = 0; start < 20; ++start) {
    // From gentle to wild: at last every node is metres away and turned anyhow.
    const double amount = 0.1 * (start + 1);
    Solution from = best;
    for (Pose2& pose : from.node_slam) {
      pose.translation += amount * Vector2d(noise(random), noise(random));
      pose.heading = start < 15 ? pose.heading + 0.2 * amount * noise(random) : turn(random);
    }
    const Result<Solution> found = MeshSolver(mesh).solve(anchors, defaultSettings(model), &from);
    if (!found) continue;
    QVERIFY(found->cost >= best.cost * (1.0 - 1e-9));
    same += found->cost <= best.cost * (1.0 + 1e-6) ? 1 : 0;
  }
  QVERIFY(same >= 10);
}

void MeshSolverTest::reportsProgressAndCanBeCancelled_data() {
  QTest::addColumn<SolverBackend>("backend");
  QTest::newRow("direct") << SolverBackend::kDirect;
  QTest::newRow("Ceres") << SolverBackend::kCeres;
}

void MeshSolverTest::reportsProgressAndCanBeCancelled() {
  QFETCH(SolverBackend, backend);
  const auto mesh = corridor();
  const AnchorList anchors = testing::anchorsAt(*mesh, 20, 2, bend);
  // A given stiffness: choosing one would report several optimisations.
  const SolverSettings settings = withStiffness(defaultSettings(Model::kStretch), Stiffness::kLocal);
  MeshSolver solver(mesh, backend);
  std::vector<IterationReport> reports;
  const Result<Solution> done = solver.solve(anchors, settings, nullptr, [&](const IterationReport& report) {
    reports.push_back(report);
    return NextStep::kContinue;
  });
  QVERIFY(done.has_value());
  QVERIFY(reports.size() >= 2);
  for (std::size_t k = 1; k < reports.size(); ++k) {
    QVERIFY(reports[k].iteration > reports[k - 1].iteration);
    QVERIFY(reports[k].cost <= reports[k - 1].cost * (1.0 + 1e-12));
  }
  QVERIFY(std::abs(reports.back().cost - done->cost) < 1e-6 * done->cost);
  int calls = 0;
  const Result<Solution> stopped =
      solver.solve(anchors, defaultSettings(Model::kStretch), nullptr,
                   [&](const IterationReport&) { return ++calls == 2 ? NextStep::kStop : NextStep::kContinue; });
  QVERIFY(!stopped.has_value());
  QVERIFY(stopped.error().code == ErrorCode::kCancelled);
  QCOMPARE(calls, 2);
  // The solver is as good as before.
  const Result<Solution> again = solver.solve(anchors, settings);
  QVERIFY(std::abs(again->cost - done->cost) < 1e-8 * done->cost);
}

void MeshSolverTest::sayWhenTheyDidNotConverge() {
  const auto mesh = corridor();
  SolverSettings settings = defaultSettings(Model::kStretch);
  settings.max_iterations = 1;
  const Result<Solution> solution = MeshSolver(mesh).solve(testing::anchorsAt(*mesh, 20, 2, bend), settings);
  QVERIFY(solution.has_value());
  QVERIFY(!solution->converged);
  QCOMPARE(solution->iterations, 1);
  QCOMPARE(solution->warnings.size(), std::size_t{1});
  QVERIFY(solution->warnings[0].find("converged") != std::string::npos);
}

void MeshSolverTest::partsWithoutAnchorsFollowTheGlobalFit() {
  QFETCH(Model, model);
  const auto mesh = testing::threeRooms();
  QCOMPARE(mesh->componentCount(), std::size_t{3});
  AnchorList anchors;
  for (int k = 0; k < 6; ++k) {
    const Vector2d place(0.8 + 0.9 * k, 0.5 + (k % 3) * 2.4);
    anchors.push_back({k, place, bend(place), true, {}, {}});
  }
  const Result<Solution> solution = MeshSolver(mesh).solve(anchors, defaultSettings(model));
  QVERIFY(solution.has_value());
  QVERIFY(solution->converged);
  for (std::size_t node = 0; node < mesh->nodeCount(); ++node) {
    if (mesh->components()[node] == 0) continue;
    const Vector2d expected = solution->global_fit * mesh->centers()[node];
    QVERIFY((solution->node_slam[node].translation - expected).norm() < 1e-12);
  }
  QCOMPARE(solution->warnings.size(), std::size_t{1});
  QVERIFY(solution->warnings[0].find("2 parts") != std::string::npos);
}

void MeshSolverTest::partsWithFewAnchorsAreHeld() {
  QFETCH(Model, model);
  const auto mesh = testing::threeRooms();
  // One anchor leaves the heading of the second room to the global fit, two give the third its own.
  const AnchorList anchors = testing::fewAnchorsInThreeRooms(bend);
  const Result<Solution> solution = MeshSolver(mesh).solve(anchors, defaultSettings(model));
  QVERIFY(solution.has_value());
  QVERIFY(solution->converged);
  QVERIFY(solution->warnings.empty());
  for (const AnchorFit& fit : solution->anchors) QVERIFY(fit.residual_m < 0.2);
  for (std::size_t node = 0; node < mesh->nodeCount(); ++node) {
    QVERIFY((solution->node_slam[node].translation - bend(mesh->centers()[node])).norm() < 1.0);
  }
}

}  // namespace cad2slam

QTEST_GUILESS_MAIN(cad2slam::MeshSolverTest)
#include "mesh_solver_test.moc"
