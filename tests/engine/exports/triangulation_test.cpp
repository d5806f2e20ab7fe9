// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/exports/triangulation.h"

#include <QtTest>

#include "support/bent_hall.h"

namespace cad2slam {
namespace {

using Eigen::Vector2d;

double doubledArea(const Vector2d& a, const Vector2d& b, const Vector2d& c) {
  return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
}

}  // namespace

class TriangulationTest : public QObject {
  Q_OBJECT
 private slots:
  void trianglesCoverTheMeshOnce_data();
  void trianglesCoverTheMeshOnce();
  void aSimilarityIsExact();
  void fewerVerticesAreCoarser();
  void foldsAreRefused();
};

void TriangulationTest::trianglesCoverTheMeshOnce_data() {
  QTest::addColumn<int>("most_vertices");
  QTest::addColumn<double>("edge_m");
  QTest::newRow("each tile") << 10'000 << 1.0;
  QTest::newRow("just enough") << 231 << 1.0;
  QTest::newRow("one less") << 230 << 2.0;
  QTest::newRow("blocks of five") << 15 << 5.0;
}

void TriangulationTest::trianglesCoverTheMeshOnce() {
  QFETCH(int, most_vertices);
  QFETCH(double, edge_m);
  const TriangleMesh mesh = *triangulate(test::bentHall(), static_cast<std::size_t>(most_vertices));
  QCOMPARE(mesh.edge_m, edge_m);
  QVERIFY(mesh.vertices.size() <= static_cast<std::size_t>(most_vertices));
  double area = 0.0;
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t vertex : triangle) QVERIFY(vertex < mesh.vertices.size());
    const PointPair& a = mesh.vertices[triangle[0]];
    const PointPair& b = mesh.vertices[triangle[1]];
    const PointPair& c = mesh.vertices[triangle[2]];
    const double doubled = doubledArea(a.source, b.source, c.source);
    QVERIFY(doubled > 0.0 && doubledArea(a.target, b.target, c.target) > 0.0);
    area += 0.5 * doubled;
  }
  QVERIFY(std::abs(area - 200.0) < 1e-9);  // of all tiles
}

void TriangulationTest::aSimilarityIsExact() {
  const TriangleMesh mesh = *triangulate(*Projector::create(test::straightHallData(0.9, {{1.0, 2.0}, -1.0})), 40);
  QVERIFY(mesh.max_deviation_m < 1e-9);
  for (const PointPair& vertex : mesh.vertices) {
    const Vector2d expected = 0.9 * (rotationMatrix(-1.0) * vertex.source) + Vector2d(1.0, 2.0);
    QVERIFY((vertex.target - expected).norm() < 1e-9);
  }
}

void TriangulationTest::fewerVerticesAreCoarser() {
  const Projector projector = test::bentHall();
  const TriangleMesh fine = *triangulate(projector, 10'000);
  const TriangleMesh coarse = *triangulate(projector, 30);
  QVERIFY(fine.max_deviation_m < 0.1 && coarse.max_deviation_m > 3.0 * fine.max_deviation_m);
}

void TriangulationTest::foldsAreRefused() {
  ProjectorData data = test::bentHallData();
  std::swap(data.node_slam[50], data.node_slam[70]);
  const Result<TriangleMesh> mesh = triangulate(*Projector::create(data), 10'000);
  QVERIFY(!mesh);
  QCOMPARE(mesh.error().code, ErrorCode::kOutOfDomain);
  QVERIFY(QString::fromStdString(mesh.error().message).contains("folds near"));
  QVERIFY(!triangulate(test::bentHall(), 3));
}

}  // namespace cad2slam

QTEST_APPLESS_MAIN(cad2slam::TriangulationTest)
#include "triangulation_test.moc"
