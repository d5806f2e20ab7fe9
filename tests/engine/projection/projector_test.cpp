// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include <QtTest>

#include <random>

#include "cad2slam/projection/make_projector.h"
#include "cad2slam/projection/projector.h"
#include "cad2slam/solver/mesh_solver.h"
#include "support/paper_data.h"
#include "support/synthetic_buildings.h"

namespace cad2slam {
namespace {

/// A smooth bend with some stretch: invertible over the U-shaped corridor.
Eigen::Vector2d bend(const Eigen::Vector2d& p) {
  const Eigen::Vector2d turned = rotationMatrix(2.9) * p;
  return {1.05 * turned.x() + 0.4 * std::sin(0.2 * p.y()), turned.y() + 0.5 * std::cos(0.15 * p.x())};
}

struct Solved {
  std::shared_ptr<const Mesh> mesh;
  Solution solution;
};

Solved solvedCorridor(Model model) {
  const auto mesh = testing::meshOf(testing::uShapedCorridor(), 0.5);
  const AnchorList anchors = testing::anchorsAt(*mesh, 25, 4, bend);
  return {mesh, *MeshSolver(mesh).solve(anchors, defaultSettings(model))};
}

double headingDifference(double a, double b) {
  return std::abs(wrapAngle(a - b));
}

/// The definition in the header, evaluated naively over all nodes.
Projection bruteForce(const ProjectorData& data, const Pose2& pose) {
  const TileLattice& lattice = data.info.lattice;
  const Eigen::Vector2d cells = lattice.cellsFromBlueprint(pose.translation);
  const auto spline = [](double t) {
    const double d = std::abs(t);
    return d < 0.5 ? 0.75 - d * d : d < 1.5 ? 0.5 * (1.5 - d) * (1.5 - d) : 0.0;
  };
  double total = 0.0;
  Eigen::Vector2d position = Eigen::Vector2d::Zero();
  Eigen::Matrix2d linear = Eigen::Matrix2d::Zero();
  for (std::size_t i = 0; i < data.node_tile.size(); ++i) {
    double weight =
        spline(cells.x() - data.node_tile[i].column - 0.5) * spline(cells.y() - data.node_tile[i].row - 0.5);
    if (data.info.weights == BlendWeights::kPaper) {
      const double distance = (pose.translation - data.node_blueprint[i]).norm();
      weight = distance < data.info.radius_m ? 1.0 / (distance + 1e-3) : 0.0;
    }
    const Eigen::Matrix2d node = data.info.scale * rotationMatrix(data.node_slam[i].heading) *
                                 data.node_stretch[i].array().exp().matrix().asDiagonal();
    total += weight;
    position += weight * (data.node_slam[i].translation + node * (pose.translation - data.node_blueprint[i]));
    linear += weight * node;
  }
  const Eigen::Vector2d direction = linear * Eigen::Vector2d(std::cos(pose.heading), std::sin(pose.heading));
  return {{position / total, std::atan2(direction.y(), direction.x())}, ProjectionStatus::kInside};
}

}  // namespace

class ProjectorTest : public QObject {
  Q_OBJECT
 private slots:
  void agreesWithTheDefinition_data();
  void agreesWithTheDefinition();
  void thereAndBackIsTheStart_data();
  void thereAndBackIsTheStart();
  void thereAndBackOnRealBuildings_data();
  void thereAndBackOnRealBuildings();
  void doesNotJump();
  void jacobianIsTheDerivative();
  void outsideFollowsThePolicy();
  void extrapolationIsContinuousAndInvertible();
  void foldsAreNamed();
  void overlapsAreNamed();
  void batchEqualsSingleQueries();
  void aHintChangesNothing();
  void refusesBrokenArrays();
};

void ProjectorTest::agreesWithTheDefinition_data() {
  QTest::addColumn<bool>("paper_weights");
  QTest::newRow("smooth") << false;
  QTest::newRow("paper") << true;
}

void ProjectorTest::agreesWithTheDefinition() {
  QFETCH(bool, paper_weights);
  const Solved solved = solvedCorridor(Model::kStretch);
  ProjectorOptions options;
  options.weights = paper_weights ? BlendWeights::kPaper : BlendWeights::kSmooth;
  options.radius_m = 2.0;
  const Result<ProjectorData> data = makeProjectorData(*solved.mesh, solved.solution, {}, options);
  QVERIFY(data.has_value());
  const Projector projector = *Projector::create(*data);
  std::mt19937 random(5);
  for (int k = 0; k < 500; ++k) {
    const Pose2 pose{testing::randomPlace(*solved.mesh, random), 0.01 * k};
    const Projection expected = bruteForce(*data, pose);
    const Projection found = projector.slamFromBlueprint(pose);
    QVERIFY(found.status == ProjectionStatus::kInside);
    QVERIFY((found.pose.translation - expected.pose.translation).norm() < 1e-10);
    QVERIFY(headingDifference(found.pose.heading, expected.pose.heading) < 1e-10);
  }
}

void ProjectorTest::thereAndBackIsTheStart_data() {
  QTest::addColumn<bool>("stretch");
  QTest::newRow("rigid") << false;
  QTest::newRow("stretch") << true;
}

void ProjectorTest::thereAndBackIsTheStart() {
  QFETCH(bool, stretch);
  const Solved solved = solvedCorridor(stretch ? Model::kStretch : Model::kRigid);
  const Projector projector = *makeProjector(*solved.mesh, solved.solution);
  QCOMPARE(projector.foldedTileCount(), std::size_t{0});
  std::mt19937 random(6);
  std::uniform_real_distribution<double> heading(-kPi, kPi);
  for (int k = 0; k < 20000; ++k) {
    const Pose2 pose{testing::randomPlace(*solved.mesh, random), heading(random)};
    const Projection there = projector.slamFromBlueprint(pose);
    QVERIFY(there.ok());
    const Projection back = projector.blueprintFromSlam(there.pose);
    QVERIFY(back.status == ProjectionStatus::kInside);
    QVERIFY((back.pose.translation - pose.translation).norm() < 1e-6);
    QVERIFY(headingDifference(back.pose.heading, pose.heading) < 1e-6);
  }
}

void ProjectorTest::thereAndBackOnRealBuildings_data() {
  QTest::addColumn<QString>("site");
  for (const char* site : {"demo", "demo_2", "demo_3", "diag", "eiii-0"}) QTest::newRow(site) << QString(site);
}

void ProjectorTest::thereAndBackOnRealBuildings() {
  QFETCH(QString, site);
  CAD2SLAM_SKIP_WITHOUT_PAPER_SITE(site);
  const Result<testing::PaperSite> data = testing::loadPaperSite(site);
  QVERIFY(data.has_value());
  const auto mesh = testing::meshOf(data->blueprint.grid, data->cell_size_m);
  const Result<Solution> solution = MeshSolver(mesh).solve(data->anchors, defaultSettings(Model::kStretch));
  QVERIFY(solution.has_value());
  const Projector projector = *makeProjector(*mesh, *solution);
  std::mt19937 random(8);
  std::uniform_real_distribution<double> heading(-kPi, kPi);
  for (int k = 0; k < 100000; ++k) {
    const Pose2 pose{testing::randomPlace(*mesh, random), heading(random)};
    const Projection there = projector.slamFromBlueprint(pose, OutsidePolicy::kError);
    QVERIFY(there.ok());
    const Projection back = projector.blueprintFromSlam(there.pose, OutsidePolicy::kError);
    QVERIFY2(back.ok(), qPrintable(QString("status %1 at %2 %3")
                                       .arg(static_cast<int>(back.status))
                                       .arg(pose.translation.x())
                                       .arg(pose.translation.y())));
    QVERIFY((back.pose.translation - pose.translation).norm() < 1e-6);
    QVERIFY(headingDifference(back.pose.heading, pose.heading) < 1e-6);
  }
}

void ProjectorTest::doesNotJump() {
  const Solved solved = solvedCorridor(Model::kStretch);
  const Projector projector = *makeProjector(*solved.mesh, solved.solution);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> angle(-kPi, kPi);
  for (int k = 0; k < 20000; ++k) {
    const Eigen::Vector2d place = testing::randomPlace(*solved.mesh, random);
    const Eigen::Vector2d next = place + 0.01 * (rotationMatrix(angle(random)) * Eigen::Vector2d(1.0, 0.0));
    const Projection a = projector.slamFromBlueprint({place, 0.0});
    const Projection b = projector.slamFromBlueprint({next, 0.0});
    if (!a.ok() || !b.ok()) continue;
    QVERIFY((a.pose.translation - b.pose.translation).norm() < 1.5 * 0.01 * solved.solution.global_fit.scale);
  }
}

void ProjectorTest::jacobianIsTheDerivative() {
  const Solved solved = solvedCorridor(Model::kStretch);
  const Projector projector = *makeProjector(*solved.mesh, solved.solution);
  std::mt19937 random(17);
  for (int k = 0; k < 200; ++k) {
    const Eigen::Vector2d place = testing::randomPlace(*solved.mesh, random);
    const Eigen::Matrix2d jacobian = projector.jacobian(place);
    for (int axis = 0; axis < 2; ++axis) {
      constexpr double kStep = 1e-6;
      const Eigen::Vector2d step = kStep * Eigen::Vector2d::Unit(axis);
      const Projection ahead = projector.slamFromBlueprint({place + step, 0.0});
      const Projection behind = projector.slamFromBlueprint({place - step, 0.0});
      if (!ahead.ok() || !behind.ok()) continue;
      const Eigen::Vector2d slope = (ahead.pose.translation - behind.pose.translation) / (2.0 * kStep);
      QVERIFY((slope - jacobian.col(axis)).norm() < 1e-6);
    }
  }
}

void ProjectorTest::outsideFollowsThePolicy() {
  const Solved solved = solvedCorridor(Model::kStretch);
  const Projector projector = *makeProjector(*solved.mesh, solved.solution);
  const Pose2 in_the_court{{7.0, 12.0}, 0.3};
  const Projection refused = projector.slamFromBlueprint(in_the_court, OutsidePolicy::kError);
  QVERIFY(refused.status == ProjectionStatus::kOutside);
  QVERIFY(!refused.pose.translation.allFinite());
  const Projection carried = projector.slamFromBlueprint(in_the_court, OutsidePolicy::kRigid);
  QVERIFY(carried.status == ProjectionStatus::kExtrapolated);
  QVERIFY((carried.pose.translation - bend(in_the_court.translation)).norm() < 2.0);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  QVERIFY(projector.slamFromBlueprint({{nan, 0.0}, 0.0}).status == ProjectionStatus::kInvalid);
  QVERIFY(projector.blueprintFromSlam({{0.0, 0.0}, nan}).status == ProjectionStatus::kInvalid);
  for (const double far : {1e6, 1e12, 1e300}) {
    QVERIFY(projector.slamFromBlueprint({{far, -far}, 0.0}).status == ProjectionStatus::kOutside);
    QVERIFY(!projector.blueprintFromSlam({{far, -far}, 0.0}).ok());
  }
}

void ProjectorTest::extrapolationIsContinuousAndInvertible() {
  const Solved solved = solvedCorridor(Model::kStretch);
  const Projector projector = *makeProjector(*solved.mesh, solved.solution);
  int answered = 0;
  std::mt19937 random(21);
  std::uniform_real_distribution<double> place(-1.0, 1.0);
  for (int k = 0; k < 2000; ++k) {
    const Eigen::Vector2d beyond = Eigen::Vector2d(-3.0, 8.0) + Eigen::Vector2d(place(random), 4.0 * place(random));
    const Projection there = projector.slamFromBlueprint({beyond, 0.4}, OutsidePolicy::kRigid);
    const Projection step =
        projector.slamFromBlueprint({beyond + Eigen::Vector2d(1e-6, 1e-6), 0.4}, OutsidePolicy::kRigid);
    QVERIFY(there.ok() && step.ok());
    QVERIFY((there.pose.translation - step.pose.translation).norm() < 1e-5);
    const Projection back = projector.blueprintFromSlam(there.pose, OutsidePolicy::kRigid);
    if (!back.ok()) continue;
    ++answered;
    QVERIFY((back.pose.translation - beyond).norm() < 1e-6);
    QVERIFY(headingDifference(back.pose.heading, 0.4) < 1e-6);
  }
  QVERIFY(answered > 1900);
}

void ProjectorTest::foldsAreNamed() {
  // Three tiles in a row, the middle one pulled beyond the right one.
  ProjectorData data;
  for (std::int32_t k = 0; k < 5; ++k) {
    data.node_tile.push_back({k, 0});
    data.node_blueprint.emplace_back(k + 0.5, 0.5);
    data.node_slam.push_back({{k + 0.5, 0.5}, 0.0});
    data.node_stretch.emplace_back(0.0, 0.0);
  }
  data.node_slam[2].translation.x() = 5.5;
  const Projector projector = *Projector::create(data);
  QVERIFY(projector.foldedTileCount() > 0);
  int folded = 0;
  for (double x = 0.01; x < 5.0; x += 0.01) {
    const Projection there = projector.slamFromBlueprint({{x, 0.5}, 0.0});
    if (there.status == ProjectionStatus::kFolded) {
      ++folded;
      continue;
    }
    const Projection back = projector.blueprintFromSlam(there.pose);
    // Never a wrong place: either the start, or no answer.
    if (back.ok()) QVERIFY(std::abs(back.pose.translation.x() - x) < 1e-6);
  }
  QVERIFY(folded > 10);
}

void ProjectorTest::overlapsAreNamed() {
  // Two far rooms that the SLAM map puts on top of each other.
  ProjectorData data;
  for (std::int32_t room = 0; room < 2; ++room) {
    for (std::int32_t k = 0; k < 16; ++k) {
      const TileCoordinate tile{room * 50 + k % 4, k / 4};
      data.node_tile.push_back(tile);
      data.node_blueprint.emplace_back(tile.column + 0.5, tile.row + 0.5);
      data.node_slam.push_back({{k % 4 + 0.5 + 0.3 * room, tile.row + 0.5}, 0.0});
      data.node_stretch.emplace_back(0.0, 0.0);
    }
  }
  const Projector projector = *Projector::create(data);
  const Projection there = projector.slamFromBlueprint({{2.0, 2.0}, 0.0});
  QVERIFY(there.ok());
  QVERIFY(projector.blueprintFromSlam(there.pose).status == ProjectionStatus::kFolded);
  QVERIFY(projector.blueprintFromSlam({{0.1, 2.0}, 0.0}).ok());
}

void ProjectorTest::batchEqualsSingleQueries() {
  const Solved solved = solvedCorridor(Model::kStretch);
  const Projector projector = *makeProjector(*solved.mesh, solved.solution);
  std::mt19937 random(31);
  std::vector<Pose2> poses;
  for (int k = 0; k < 30000; ++k) poses.push_back({testing::randomPlace(*solved.mesh, random), 0.1 * k});
  std::vector<Projection> there(poses.size());
  projector.slamFromBlueprint(poses.data(), there.data(), poses.size(), OutsidePolicy::kError, 3);
  for (std::size_t k = 0; k < poses.size(); ++k) {
    const Projection single = projector.slamFromBlueprint(poses[k]);
    QVERIFY(single.status == there[k].status && single.pose.translation == there[k].pose.translation &&
            single.pose.heading == there[k].pose.heading);
  }
}

void ProjectorTest::aHintChangesNothing() {
  const Solved solved = solvedCorridor(Model::kStretch);
  const Projector projector = *makeProjector(*solved.mesh, solved.solution);
  std::mt19937 random(32);
  std::uniform_real_distribution<double> anywhere(-60.0, 60.0);
  for (int k = 0; k < 3000; ++k) {
    const Pose2 truth{testing::randomPlace(*solved.mesh, random), 0.1 * k};
    const Pose2 in_slam = k % 3 == 0 ? Pose2{{anywhere(random), anywhere(random)}, 0.0}
                                     : projector.slamFromBlueprint(truth, OutsidePolicy::kRigid).pose;
    const Projection plain = projector.blueprintFromSlam(in_slam, OutsidePolicy::kRigid);
    for (const Eigen::Vector2d& hint : {truth.translation, Eigen::Vector2d(anywhere(random), anywhere(random))}) {
      const Projection hinted = projector.blueprintFromSlam(in_slam, OutsidePolicy::kRigid, hint);
      QVERIFY(hinted.status == plain.status);
      if (plain.ok()) QVERIFY((hinted.pose.translation - plain.pose.translation).norm() < 1e-8);
    }
  }
}

void ProjectorTest::refusesBrokenArrays() {
  ProjectorData good;
  good.node_tile = {{0, 0}, {1, 0}};
  good.node_blueprint = {{0.5, 0.5}, {1.5, 0.5}};
  good.node_slam = {{{0.5, 0.5}, 0.0}, {{1.5, 0.5}, 0.0}};
  good.node_stretch = {{0.0, 0.0}, {0.0, 0.0}};
  QVERIFY(Projector::create(good).has_value());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto refused = [&](const auto& spoil) {
    ProjectorData bad = good;
    spoil(bad);
    const Result<Projector> made = Projector::create(bad);
    return !made.has_value() && made.error().code == ErrorCode::kMalformed;
  };
  QVERIFY(refused([](ProjectorData& d) { d.node_slam.pop_back(); }));
  QVERIFY(refused([&](ProjectorData& d) { d.node_slam[1].heading = nan; }));
  QVERIFY(refused([](ProjectorData& d) { d.node_tile[1] = {0, 0}; }));
  QVERIFY(refused([](ProjectorData& d) { d.node_blueprint[1] = {9.0, 0.5}; }));
  QVERIFY(refused([](ProjectorData& d) { d.node_stretch[0] = {40.0, 0.0}; }));
  QVERIFY(refused([](ProjectorData& d) { d.info.scale = 0.0; }));
  QVERIFY(refused([&](ProjectorData& d) { d.info.lattice.cell_size = nan; }));
  QVERIFY(refused([](ProjectorData& d) { d = {}; }));
}

}  // namespace cad2slam

QTEST_GUILESS_MAIN(cad2slam::ProjectorTest)
#include "projector_test.moc"
