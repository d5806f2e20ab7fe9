// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include <QtTest>

#include <limits>

#include "cad2slam/solver/mesh_solver.h"
#include "support/synthetic_buildings.h"

/// Anchors as installers and broken files give them: few, on a line, twice, contradicting, far away, not numbers.
namespace cad2slam {
namespace {

using Eigen::Vector2d;

Vector2d bend(const Vector2d& p) {
  const Vector2d turned = rotationMatrix(2.9) * p;
  return {1.03 * turned.x() + 0.8 * std::sin(0.2 * p.y()), turned.y() + 0.9 * std::cos(0.15 * p.x())};
}

AnchorList anchorsOn(const std::vector<Vector2d>& places) {
  AnchorList anchors;
  for (const Vector2d& place : places) {
    anchors.push_back({static_cast<AnchorId>(anchors.size() + 1), place, bend(place), true, {}, {}});
  }
  return anchors;
}

/// Spread over the corridor of 20 x 12 m.
AnchorList goodAnchors() {
  return anchorsOn({{-2.0, 13.0}, {-1.0, 8.0}, {-2.2, 3.0}, {6.0, 3.5}, {12.0, 2.5}, {16.0, 9.0}});
}

bool allFinite(const Solution& solution) {
  bool finite = std::isfinite(solution.cost);
  for (const Pose2& pose : solution.node_slam) finite = finite && pose.isFinite();
  for (const Vector2d& stretch : solution.node_stretch) finite = finite && stretch.allFinite();
  for (const AnchorFit& fit : solution.anchors) finite = finite && std::isfinite(fit.residual_m);
  return finite;
}

}  // namespace

class MeshSolverAnchorsTest : public QObject {
  Q_OBJECT
 private slots:
  void init() { mesh_ = testing::meshOf(testing::uShapedCorridor(), 1.0); }
  void noAnchor();
  void oneAnchorTranslates();
  void twoAnchorsTurn();
  void threeAnchorsBend_data() { models(); }
  void threeAnchorsBend();
  void anchorsOnALine_data() { models(); }
  void anchorsOnALine();
  void agreeingDuplicatesCountAsOnePlace();
  void agreeingDuplicatesAreHarmless_data() { models(); }
  void agreeingDuplicatesAreHarmless();
  void contradictionsAreNamed();
  void repeatedIdsAreNamed();
  void numbersThatAreNoneAreNamed();
  void farAwayAnchorsDoNoHarm_data() { models(); }
  void farAwayAnchorsDoNoHarm();
  void absurdCoordinatesEndInAnAnswerOrAnError_data();
  void absurdCoordinatesEndInAnAnswerOrAnError();
  void disabledAnchorsAreOnlyReported_data() { models(); }
  void disabledAnchorsAreOnlyReported();

 private:
  static void models();
  std::shared_ptr<const Mesh> mesh_;
};

void MeshSolverAnchorsTest::models() {
  QTest::addColumn<Model>("model");
  QTest::newRow("rigid") << Model::kRigid;
  QTest::newRow("stretch") << Model::kStretch;
}

void MeshSolverAnchorsTest::noAnchor() {
  AnchorList disabled = goodAnchors();
  for (Anchor& anchor : disabled) anchor.enabled = false;
  for (const AnchorList& anchors : {AnchorList{}, disabled}) {
    MeshSolver solver(mesh_);
    const Result<Solution> solution = solver.solve(anchors, defaultSettings(Model::kStretch));
    QVERIFY(!solution.has_value());
    QVERIFY(solution.error().code == ErrorCode::kDegenerate);
    QVERIFY(std::isnan(solver.projectionSigma({mesh_->centers()[0]})[0]));
  }
}

void MeshSolverAnchorsTest::oneAnchorTranslates() {
  MeshSolver solver(mesh_);
  const AnchorList anchors = anchorsOn({{6.0, 3.5}});
  const Result<Solution> solution = solver.solve(anchors, defaultSettings(Model::kStretch));
  QVERIFY(solution.has_value());
  const Vector2d shift = anchors[0].in_slam - anchors[0].in_blueprint;
  for (std::size_t node = 0; node < mesh_->nodeCount(); ++node) {
    QVERIFY((solution->node_slam[node].translation - mesh_->centers()[node] - shift).norm() < 1e-12);
    QCOMPARE(solution->node_slam[node].heading, 0.0);
  }
  QCOMPARE(solution->anchors_used, std::size_t{1});
  QVERIFY(solution->anchors[0].residual_m < 1e-12);
  QVERIFY(std::isnan(solution->anchors[0].leave_one_out_m));
  QCOMPARE(solution->warnings.size(), std::size_t{1});
  QVERIFY(std::isnan(solver.projectionSigma({mesh_->centers()[0]})[0]));
}

void MeshSolverAnchorsTest::twoAnchorsTurn() {
  for (const double scale : {1.0, 1.2}) {
    const Similarity2 truth{scale, 2.2, {4.0, 5.0}};
    AnchorList anchors = anchorsOn({{-2.0, 13.0}, {16.0, 4.0}});
    for (Anchor& anchor : anchors) anchor.in_slam = truth * anchor.in_blueprint;
    SolverSettings settings = defaultSettings(Model::kStretch);
    settings.scale.rule = ScaleRule::kLeastSquares;
    const Result<Solution> solution = MeshSolver(mesh_).solve(anchors, settings);
    QVERIFY(solution.has_value());
    for (std::size_t node = 0; node < mesh_->nodeCount(); ++node) {
      QVERIFY((solution->node_slam[node].translation - truth * mesh_->centers()[node]).norm() < 1e-10);
      QVERIFY(std::abs(wrapAngle(solution->node_slam[node].heading - 2.2)) < 1e-12);
    }
    QCOMPARE(solution->warnings.size(), std::size_t{1});
  }
}

void MeshSolverAnchorsTest::threeAnchorsBend() {
  QFETCH(Model, model);
  const AnchorList anchors = anchorsOn({{-2.0, 13.0}, {6.0, 3.5}, {16.0, 9.0}});
  const Result<Solution> solution = MeshSolver(mesh_).solve(anchors, defaultSettings(model));
  QVERIFY(solution.has_value());
  QVERIFY(solution->converged && allFinite(*solution));
  QVERIFY(solution->warnings.empty());
  for (const AnchorFit& fit : solution->anchors) {
    QVERIFY(fit.residual_m < 0.2);
    QVERIFY(fit.leave_one_out_m >= fit.residual_m);
  }
}

void MeshSolverAnchorsTest::anchorsOnALine() {
  QFETCH(Model, model);
  const AnchorList anchors = anchorsOn({{-2.0, 3.5}, {2.0, 3.5}, {6.0, 3.5}, {12.0, 3.5}, {16.0, 3.5}});
  const Result<Solution> solution = MeshSolver(mesh_).solve(anchors, defaultSettings(model));
  QVERIFY(solution.has_value());
  QVERIFY(solution->converged && allFinite(*solution));
  for (const AnchorFit& fit : solution->anchors) QVERIFY(fit.residual_m < 0.3);
}

void MeshSolverAnchorsTest::agreeingDuplicatesCountAsOnePlace() {
  const Result<Solution> one =
      MeshSolver(mesh_).solve(anchorsOn({{6.0, 3.5}, {6.0, 3.5}, {6.0, 3.5}}), defaultSettings(Model::kStretch));
  QVERIFY(one.has_value());
  QCOMPARE(one->global_fit.heading, 0.0);
  const Result<Solution> two =
      MeshSolver(mesh_).solve(anchorsOn({{6.0, 3.5}, {6.0, 3.5}, {16.0, 9.0}}), defaultSettings(Model::kStretch));
  QVERIFY(two.has_value());
  QCOMPARE(two->warnings.size(), std::size_t{1});
  QCOMPARE(two->anchors_used, std::size_t{3});
}

void MeshSolverAnchorsTest::agreeingDuplicatesAreHarmless() {
  QFETCH(Model, model);
  AnchorList anchors = goodAnchors();
  Anchor again = anchors[3];
  again.id = 70;
  again.in_slam += Vector2d(0.05, -0.02);  // clicked once more
  anchors.push_back(again);
  const Result<Solution> solution = MeshSolver(mesh_).solve(anchors, defaultSettings(model));
  QVERIFY(solution.has_value());
  QVERIFY(solution->converged && allFinite(*solution));
  QVERIFY(solution->anchors.back().leave_one_out_m < 0.3);
}

void MeshSolverAnchorsTest::contradictionsAreNamed() {
  for (const bool in_slam : {false, true}) {
    AnchorList anchors = goodAnchors();
    anchors[4].id = 41;
    anchors[1].id = 17;
    (in_slam ? anchors[4].in_slam : anchors[4].in_blueprint) = in_slam ? anchors[1].in_slam : anchors[1].in_blueprint;
    const Result<Solution> solution = MeshSolver(mesh_).solve(anchors, defaultSettings(Model::kStretch));
    QVERIFY(!solution.has_value());
    QVERIFY(solution.error().code == ErrorCode::kDegenerate);
    QVERIFY(solution.error().sentence().find("anchors 17 and 41") != std::string::npos);
  }
}

void MeshSolverAnchorsTest::repeatedIdsAreNamed() {
  AnchorList anchors = goodAnchors();
  anchors[4].id = anchors[2].id;
  const Result<Solution> solution = MeshSolver(mesh_).solve(anchors, defaultSettings(Model::kStretch));
  QVERIFY(!solution.has_value());
  QCOMPARE(solution.error().where, std::string("anchor 3"));
}

void MeshSolverAnchorsTest::numbersThatAreNoneAreNamed() {
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), HUGE_VAL, -HUGE_VAL}) {
    for (int coordinate = 0; coordinate < 4; ++coordinate) {
      for (const bool enabled : {true, false}) {
        AnchorList anchors = goodAnchors();
        Anchor& broken = anchors[2];
        (coordinate < 2 ? broken.in_blueprint : broken.in_slam)[coordinate % 2] = bad;
        broken.enabled = enabled;
        const Result<Solution> solution = MeshSolver(mesh_).solve(anchors, defaultSettings(Model::kStretch));
        QVERIFY(!solution.has_value());
        QVERIFY(solution.error().code == ErrorCode::kMalformed);
        QCOMPARE(solution.error().where, std::string("anchor 3"));
      }
    }
  }
}

/// The solver knows no rasters, so an anchor off the mesh is one on its nearest node.
void MeshSolverAnchorsTest::farAwayAnchorsDoNoHarm() {
  QFETCH(Model, model);
  for (const double distance : {5.0, 1e3, 1e6}) {
    AnchorList anchors = goodAnchors();
    const Vector2d far(-distance, 0.3 * distance);
    anchors.push_back({70, far, bend(far), true, {}, {}});
    const Result<Solution> solution = MeshSolver(mesh_).solve(anchors, defaultSettings(model));
    QVERIFY2(solution, solution ? "" : solution.error().sentence().c_str());
    QVERIFY(allFinite(*solution));
    QCOMPARE(solution->anchors_used, std::size_t{7});
  }
}

void MeshSolverAnchorsTest::absurdCoordinatesEndInAnAnswerOrAnError_data() {
  QTest::addColumn<Model>("model");
  QTest::addColumn<double>("coordinate");
  for (const double coordinate : {1e-300, 1e9, 1e15, 1e100, 1e200, 1e308}) {
    for (const Model model : {Model::kRigid, Model::kStretch}) {
      QTest::addRow("%g, %s", coordinate, model == Model::kRigid ? "rigid" : "stretch") << model << coordinate;
    }
  }
}

void MeshSolverAnchorsTest::absurdCoordinatesEndInAnAnswerOrAnError() {
  QFETCH(Model, model);
  QFETCH(double, coordinate);
  for (const bool in_blueprint : {false, true}) {
    for (const SolverBackend backend : {SolverBackend::kDirect, SolverBackend::kCeres}) {
      AnchorList anchors = goodAnchors();
      (in_blueprint ? anchors[1].in_blueprint : anchors[1].in_slam) = {coordinate, -coordinate};
      MeshSolver solver(mesh_, backend);
      const Result<Solution> solution = solver.solve(anchors, defaultSettings(model));
      if (solution) {
        QVERIFY(allFinite(*solution));
      } else {
        QVERIFY(!solution.error().message.empty());
      }
    }
  }
}

void MeshSolverAnchorsTest::disabledAnchorsAreOnlyReported() {
  QFETCH(Model, model);
  AnchorList anchors = goodAnchors();
  const Solution without = *MeshSolver(mesh_).solve(anchors, defaultSettings(model));
  Anchor check = anchors[0];
  check.id = 50;
  check.in_blueprint = {-1.0, 5.0};
  check.in_slam = bend(check.in_blueprint) + Vector2d(3.0, 4.0);
  check.enabled = false;
  anchors.insert(anchors.begin() + 2, check);
  const Solution with = *MeshSolver(mesh_).solve(anchors, defaultSettings(model));
  QCOMPARE(with.cost, without.cost);
  QCOMPARE(with.anchors.size(), anchors.size());
  QCOMPARE(with.anchors_used, without.anchors_used);
  for (std::size_t k = 0; k < anchors.size(); ++k) QCOMPARE(with.anchors[k].id, anchors[k].id);
  QVERIFY(!with.anchors[2].used);
  QVERIFY(std::abs(with.anchors[2].residual_m - 5.0) < 1.0);
  QCOMPARE(with.anchors[2].leave_one_out_m, with.anchors[2].residual_m);
}

}  // namespace cad2slam

QTEST_GUILESS_MAIN(cad2slam::MeshSolverAnchorsTest)
#include "mesh_solver_anchors_test.moc"
