// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include <QtTest>

#include <random>

#include "cad2slam/mesh/mesh_builder.h"
#include "support/paper_data.h"
#include "support/synthetic_buildings.h"

namespace cad2slam {

class MeshBuilderTest : public QObject {
  Q_OBJECT
 private slots:
  void countsOfThePaper_data();
  void countsOfThePaper();
  void everyFreePixelLiesOnANode();
  void lastTilesAreShiftedInside();
  void automaticCellSizeMeetsTheBudget();
  void turnedFrameTurnsTheMesh();
  void refusesWhatCannotBeMeshed();
};

void MeshBuilderTest::countsOfThePaper_data() {
  QTest::addColumn<QString>("site");
  for (const char* site : {"demo", "demo_2", "demo_3", "diag", "eiii-0"}) QTest::newRow(site) << QString(site);
}

void MeshBuilderTest::countsOfThePaper() {
  QFETCH(QString, site);
  CAD2SLAM_SKIP_WITHOUT_PAPER_SITE(site);
  const Result<testing::PaperSite> data = testing::loadPaperSite(site);
  QVERIFY2(data.has_value(), data ? "" : data.error().sentence().c_str());
  const Result<Mesh> mesh = buildMesh(data->blueprint.grid, data->cell_size_m);
  QVERIFY(mesh.has_value());
  QCOMPARE(mesh->nodeCount(), data->nodes);
  QCOMPARE(mesh->edges().size(), data->edges);
}

void MeshBuilderTest::everyFreePixelLiesOnANode() {
  std::mt19937 random(3);
  std::bernoulli_distribution is_free(0.02);
  const OccupancyGrid grid = testing::drawGrid(*MapFrame::create(0.05, 173, 91, {{5.0, -2.0}, 0.7}),
                                               [&](int, int) { return is_free(random); });
  const Result<Mesh> mesh = buildMesh(grid, 0.4);
  QVERIFY(mesh.has_value());
  for (int row = 0; row < 91; ++row) {
    for (int column = 0; column < 173; ++column) {
      if (grid.at(column, row) != CellState::kFree) continue;
      const Eigen::Vector2d center = grid.frame().metricFromPixel({column + 0.5, row + 0.5});
      const Eigen::Vector2d cells = mesh->lattice().cellsFromBlueprint(center);
      QVERIFY(mesh->index().at(static_cast<int>(std::floor(cells.x())), static_cast<int>(std::floor(cells.y()))) !=
              TileIndex::kNone);
    }
  }
}

void MeshBuilderTest::lastTilesAreShiftedInside() {
  const OccupancyGrid grid = testing::drawGrid(*MapFrame::create(1.0, 25, 12, {}), [](int, int) { return true; });
  const Result<Mesh> mesh = buildMesh(grid, 10.0);
  QVERIFY(mesh.has_value());
  QCOMPARE(mesh->nodeCount(), std::size_t{6});
  QCOMPARE(mesh->centers()[0], Eigen::Vector2d(5.0, 7.0));
  QCOMPARE(mesh->centers()[2], Eigen::Vector2d(20.0, 7.0));
  QCOMPARE(mesh->centers()[5], Eigen::Vector2d(20.0, 5.0));
}

void MeshBuilderTest::automaticCellSizeMeetsTheBudget() {
  const OccupancyGrid grid = testing::uShapedCorridor();
  for (const int budget : {300, 1000, 3000}) {
    const Result<Mesh> mesh = buildMesh(grid, automaticCellSize(grid, budget));
    QVERIFY(mesh.has_value());
    const auto nodes = static_cast<int>(mesh->nodeCount());
    QVERIFY(2 * nodes > budget && nodes < 2 * budget);
  }
}

void MeshBuilderTest::turnedFrameTurnsTheMesh() {
  const Pose2 turn{{3.0, -8.0}, 1.1};
  const auto is_free = [](int column, int row) { return column + row > 20; };
  const OccupancyGrid upright = testing::drawGrid(*MapFrame::create(0.1, 60, 40, {}), is_free);
  const OccupancyGrid turned = testing::drawGrid(*MapFrame::create(0.1, 60, 40, turn), is_free);
  const Result<Mesh> a = buildMesh(upright, 0.7);
  const Result<Mesh> b = buildMesh(turned, 0.7);
  QVERIFY(a.has_value() && b.has_value());
  QCOMPARE(a->nodeCount(), b->nodeCount());
  for (std::size_t k = 0; k < a->nodeCount(); ++k) {
    QVERIFY((turn * a->centers()[k] - b->centers()[k]).norm() < 1e-12);
    QVERIFY(a->tiles()[k] == b->tiles()[k]);
  }
}

void MeshBuilderTest::refusesWhatCannotBeMeshed() {
  const MapFrame frame = *MapFrame::create(0.1, 50, 50, {});
  const OccupancyGrid walls = testing::drawGrid(frame, [](int, int) { return false; });
  QCOMPARE(buildMesh(walls, 1.0).error().code, ErrorCode::kDegenerate);
  QCOMPARE(buildMesh(walls, std::nullopt).error().code, ErrorCode::kDegenerate);
  const OccupancyGrid open = testing::drawGrid(frame, [](int, int) { return true; });
  for (const double cell_size : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
    QCOMPARE(buildMesh(open, cell_size).error().code, ErrorCode::kOutOfDomain);
  }
  QCOMPARE(buildMesh(open, 1e9)->nodeCount(), std::size_t{1});
  const OccupancyGrid large = testing::drawGrid(*MapFrame::create(0.1, 2100, 2100, {}), [](int, int) { return true; });
  QCOMPARE(buildMesh(large, 0.1).error().code, ErrorCode::kOutOfDomain);
}

}  // namespace cad2slam

QTEST_GUILESS_MAIN(cad2slam::MeshBuilderTest)
#include "mesh_builder_test.moc"
