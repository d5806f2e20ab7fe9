// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include <QtTest>

#include <random>

#include "cad2slam/mesh/mesh.h"

namespace cad2slam {
namespace {

/// A full rectangle of tiles, centres in the middle of their tiles.
Result<Mesh> rectangle(std::int32_t columns, std::int32_t rows, const TileLattice& lattice) {
  std::vector<Eigen::Vector2d> centers;
  std::vector<TileCoordinate> tiles;
  for (std::int32_t row = 0; row < rows; ++row) {
    for (std::int32_t column = 0; column < columns; ++column) {
      tiles.push_back({column, row});
      centers.push_back(lattice.blueprintFromCells({column + 0.5, row + 0.5}));
    }
  }
  return Mesh::create(lattice, centers, tiles);
}

}  // namespace

class MeshTest : public QObject {
  Q_OBJECT
 private slots:
  void rectangleHasAllEdges();
  void componentsAreCutApart();
  void refusesBrokenInput();
  void nearestNodeAgreesWithBruteForce();
};

void MeshTest::rectangleHasAllEdges() {
  const Result<Mesh> mesh = rectangle(7, 5, {0.5, {{1.0, 2.0}, 0.3}});
  QVERIFY(mesh.has_value());
  QCOMPARE(mesh->nodeCount(), std::size_t{35});
  QCOMPARE(mesh->edges().size(), std::size_t{6 * 5 + 7 * 4});
  QCOMPARE(mesh->componentCount(), std::size_t{1});
  for (const MeshEdge& edge : mesh->edges()) {
    QVERIFY(std::abs((mesh->centers()[edge.to] - mesh->centers()[edge.from]).norm() - 0.5) < 1e-12);
  }
  // The box is upright in the blueprint frame, whatever the lattice is turned by.
  QVERIFY(mesh->diagonal() >= 0.5 * std::hypot(6, 4) && mesh->diagonal() < 0.5 * (6 + 4) * 1.4143);
}

void MeshTest::componentsAreCutApart() {
  const std::vector<TileCoordinate> tiles{{0, 0}, {1, 0}, {3, 0}, {3, 1}, {9, 9}, {1, 1}};
  std::vector<Eigen::Vector2d> centers;
  for (const TileCoordinate& tile : tiles) centers.emplace_back(tile.column + 0.5, tile.row + 0.5);
  const Result<Mesh> mesh = Mesh::create({}, centers, tiles);
  QVERIFY(mesh.has_value());
  QCOMPARE(mesh->componentCount(), std::size_t{3});
  QCOMPARE(mesh->components(), (std::vector<std::uint32_t>{0, 0, 1, 1, 2, 0}));
}

void MeshTest::refusesBrokenInput() {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  QCOMPARE(Mesh::create({}, {}, {}).error().code, ErrorCode::kDegenerate);
  QCOMPARE(Mesh::create({}, {{0.5, 0.5}}, {{0, 0}, {1, 0}}).error().code, ErrorCode::kMalformed);
  QCOMPARE(Mesh::create({}, {{0.5, 0.5}, {0.5, 0.5}}, {{0, 0}, {0, 0}}).error().code, ErrorCode::kMalformed);
  QCOMPARE(Mesh::create({}, {{nan, 0.5}}, {{0, 0}}).error().code, ErrorCode::kMalformed);
  QCOMPARE(Mesh::create({0.0, {}}, {{0.5, 0.5}}, {{0, 0}}).error().code, ErrorCode::kMalformed);
}

void MeshTest::nearestNodeAgreesWithBruteForce() {
  const Result<Mesh> mesh = rectangle(20, 3, {0.8, {{-4.0, 7.0}, -1.0}});
  std::mt19937 random(9);
  std::uniform_real_distribution<double> place(-60.0, 60.0);
  for (int k = 0; k < 3000; ++k) {
    const Eigen::Vector2d point(place(random), place(random));
    NodeIndex best = 0;
    for (NodeIndex node = 1; node < mesh->nodeCount(); ++node) {
      if ((mesh->centers()[node] - point).norm() < (mesh->centers()[best] - point).norm()) best = node;
    }
    const NodeIndex found = mesh->nearestNode(point);
    QVERIFY(std::abs((mesh->centers()[found] - point).norm() - (mesh->centers()[best] - point).norm()) < 1e-12);
  }
}

}  // namespace cad2slam

QTEST_GUILESS_MAIN(cad2slam::MeshTest)
#include "mesh_test.moc"
