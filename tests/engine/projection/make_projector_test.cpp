// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/projection/make_projector.h"

#include <QtTest>

#include "cad2slam/solver/mesh_solver.h"
#include "support/synthetic_buildings.h"

namespace cad2slam {
namespace {

using Eigen::Vector2d;

Vector2d bend(const Vector2d& p) {
  return rotationMatrix(0.7) * p + Vector2d(0.3 * std::sin(0.3 * p.y()), 0.2 * std::cos(0.2 * p.x()));
}

struct Solved {
  std::shared_ptr<const Mesh> mesh;
  AnchorList anchors;
  Solution solution;
};

Solved solvedCorridor(Model model) {
  const auto mesh = testing::meshOf(testing::uShapedCorridor(), 0.9);  // does not divide the sides: shifted tiles
  AnchorList anchors = testing::anchorsAt(*mesh, 15, 4, bend);
  anchors[3].enabled = false;
  const Solution solution = *MeshSolver(mesh).solve(anchors, defaultSettings(model));
  return {mesh, anchors, solution};
}

}  // namespace

class MakeProjectorTest : public QObject {
  Q_OBJECT
 private slots:
  void holdsTheSolvedMesh();
  void checkPosesAreReproduced();
  void qualityIsThatOfTheUsedAnchors();
  void optionsAreKept();
  void anchorsLandWhereTheSolutionSays_data();
  void anchorsLandWhereTheSolutionSays();
  void foldsAreCounted();
};

void MakeProjectorTest::holdsTheSolvedMesh() {
  const Solved solved = solvedCorridor(Model::kStretch);
  const ProjectorData data = *makeProjectorData(*solved.mesh, solved.solution, solved.anchors, {});
  QVERIFY(data.node_blueprint == solved.mesh->centers());
  QVERIFY(data.node_tile == solved.mesh->tiles());
  QVERIFY(data.node_stretch == solved.solution.node_stretch);
  QCOMPARE(data.node_slam.size(), solved.mesh->nodeCount());
  QCOMPARE(data.edges.size(), solved.mesh->edges().size());
  QCOMPARE(data.anchors.size(), std::size_t{14});  // without the disabled one
  QCOMPARE(data.info.model, std::string("stretch"));
  QCOMPARE(data.info.scale, solved.solution.global_fit.scale);
  const Solved rigid = solvedCorridor(Model::kRigid);
  QCOMPARE(makeProjectorData(*rigid.mesh, rigid.solution, {}, {})->info.model, std::string("rigid"));
}

void MakeProjectorTest::checkPosesAreReproduced() {
  for (const BlendWeights weights : {BlendWeights::kSmooth, BlendWeights::kPaper}) {
    const Solved solved = solvedCorridor(Model::kStretch);
    ProjectorOptions options;
    options.weights = weights;
    const ProjectorData data = *makeProjectorData(*solved.mesh, solved.solution, solved.anchors, options);
    QCOMPARE(data.check_poses.size(), std::size_t{16});
    const Projector projector = *Projector::create(data);
    for (const CheckPose& check : data.check_poses) {
      const Projection there = projector.slamFromBlueprint(check.in_blueprint);
      QVERIFY(there.status == ProjectionStatus::kInside);
      QVERIFY(there.pose.translation == check.in_slam.translation);
      QCOMPARE(there.pose.heading, check.in_slam.heading);
      if (weights == BlendWeights::kPaper) continue;  // those weights jump, so the inverse may have no answer
      const Projection back = projector.blueprintFromSlam(check.in_slam);
      QVERIFY(back.ok());
      QVERIFY((back.pose.translation - check.in_blueprint.translation).norm() < 1e-6);
    }
  }
}

void MakeProjectorTest::qualityIsThatOfTheUsedAnchors() {
  const Solved solved = solvedCorridor(Model::kStretch);
  const QualityInfo quality = makeProjectorData(*solved.mesh, solved.solution, solved.anchors, {})->info.quality;
  QCOMPARE(quality.anchors_used, std::size_t{14});
  double squares = 0.0;
  double largest = 0.0;
  double left_out = 0.0;
  for (const AnchorFit& fit : solved.solution.anchors) {
    if (!fit.used) continue;
    squares += fit.residual_m * fit.residual_m;
    largest = std::max(largest, fit.residual_m);
    left_out += fit.leave_one_out_m / 14.0;
  }
  QVERIFY(std::abs(quality.anchor_rms_m - std::sqrt(squares / 14.0)) < 1e-12);
  QCOMPARE(quality.anchor_max_m, largest);
  QVERIFY(std::abs(quality.leave_one_out_mean_m - left_out) < 1e-12);
  QVERIFY(quality.leave_one_out_median_m <= quality.leave_one_out_max_m);
  QCOMPARE(quality.folded_tiles, std::size_t{0});
}

void MakeProjectorTest::optionsAreKept() {
  const Solved solved = solvedCorridor(Model::kRigid);
  ProjectorOptions options;
  options.weights = BlendWeights::kPaper;
  options.radius_m = 2.5;
  options.outside = OutsidePolicy::kRigid;
  options.blueprint = {"ground floor", "ab", 0.1, 200, 120, {{-3.0, 2.0}, 0.0}};
  options.slam.name = "robot 7";
  options.creator = "a test";
  options.created = "2026-01-01T00:00:00Z";
  options.project = "p.c2sproj";
  options.note = "folds were accepted";
  const ProjectorInfo info = makeProjectorData(*solved.mesh, solved.solution, solved.anchors, options)->info;
  QVERIFY(info.weights == BlendWeights::kPaper && info.outside == OutsidePolicy::kRigid);
  QCOMPARE(info.radius_m, 2.5);
  QCOMPARE(info.blueprint.name, options.blueprint.name);
  QCOMPARE(info.blueprint.width_px, 200);
  QCOMPARE(info.slam.name, options.slam.name);
  QCOMPARE(info.creator, options.creator);
  QCOMPARE(info.created, options.created);
  QCOMPARE(info.project, options.project);
  QCOMPARE(info.note, options.note);
}

void MakeProjectorTest::anchorsLandWhereTheSolutionSays_data() {
  QTest::addColumn<Model>("model");
  QTest::newRow("rigid") << Model::kRigid;
  QTest::newRow("stretch") << Model::kStretch;
}

/// The residuals that the solver reports are those of the function that robots get.
void MakeProjectorTest::anchorsLandWhereTheSolutionSays() {
  QFETCH(Model, model);
  const Solved solved = solvedCorridor(model);
  const Projector projector = *makeProjector(*solved.mesh, solved.solution);
  for (std::size_t k = 0; k < solved.anchors.size(); ++k) {
    const Projection there = projector.slamFromBlueprint({solved.anchors[k].in_blueprint, 0.0}, OutsidePolicy::kError);
    if (!there.ok()) continue;
    QVERIFY((there.pose.translation - solved.solution.anchors[k].predicted).norm() < 1e-9);
  }
}

void MakeProjectorTest::foldsAreCounted() {
  Solved solved = solvedCorridor(Model::kRigid);
  solved.solution.node_slam[20].translation += Vector2d(5.0, 0.0);
  const Result<ProjectorData> data = makeProjectorData(*solved.mesh, solved.solution, solved.anchors, {});
  QVERIFY(data.has_value());
  QVERIFY(data->info.quality.folded_tiles > 0);
}

}  // namespace cad2slam

QTEST_GUILESS_MAIN(cad2slam::MakeProjectorTest)
#include "make_projector_test.moc"
