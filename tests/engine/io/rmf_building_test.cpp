// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/io/rmf_building.h"

#include <QtTest>

#include "support/damaged_text.h"

namespace cad2slam {
namespace {

using test::damaged;

const std::string kBuilding =
    "levels:\n  L1:\n    drawing: {filename: a.png}\n    features:\n      - {id: a, name: n, x: 1, y: 2}\n"
    "    layers:\n      scan:\n        filename: b.png\n        features:\n          - {id: b, name: m, x: 3, y: 4.5}\n"
    "    constraints:\n      - {ids: [a, b]}\n    vertices: [[1, 2, 0, dock], [3, 4, 0, \"\"]]\n    lanes: [[0, 1, "
    "{}]]\n";

}  // namespace

class RmfBuildingTest : public QObject {
  Q_OBJECT
 private slots:
  void pixelsBecomeMetres();
  void damagedBuildings();
};

void RmfBuildingTest::pixelsBecomeMetres() {
  const RmfLevel level = *findLevel(*parseRmfBuilding(kBuilding, "x"), "L1");
  const MapFrame blueprint = *MapFrame::create(0.5, 10, 20, {{100.0, 0.0}, 0.0});
  const MapFrame slam = *MapFrame::create(0.1, 10, 10, {});
  const AnchorList anchors = *anchorsOf(level, "scan", blueprint, slam);
  QCOMPARE(anchors.size(), std::size_t{1});
  // Rows grow down from the top edge: y = (height - row) * resolution.
  QVERIFY((anchors[0].in_blueprint - Eigen::Vector2d(100.5, 9.0)).norm() < 1e-12);
  QVERIFY((anchors[0].in_slam - Eigen::Vector2d(0.3, 0.55)).norm() < 1e-12);
  QCOMPARE(QString::fromStdString(anchors[0].name), QString("n"));
  const FeatureList lanes = lanesOf(level, blueprint);
  QCOMPARE(lanes.size(), std::size_t{2});  // the lane and the vertex with a name
  QVERIFY((lanes[0].parts[0][1] - Eigen::Vector2d(101.5, 8.0)).norm() < 1e-12);
  QCOMPARE(QString::fromStdString(lanes[1].name), QString("dock"));
  const MapFrame small = *MapFrame::create(0.1, 2, 2, {});
  QCOMPARE(anchorsOf(level, "scan", blueprint, small).error().code, ErrorCode::kOutOfDomain);
  QCOMPARE(anchorsOf(level, "other", blueprint, slam).error().code, ErrorCode::kNotFound);
}

void RmfBuildingTest::damagedBuildings() {
  QVERIFY(parseRmfBuilding(kBuilding, "x").has_value());
  const MapFrame frame = *MapFrame::create(0.1, 10, 10, {});
  std::mt19937 random(12);
  for (int k = 0; k < 5000; ++k) {
    const Result<RmfBuilding> building = parseRmfBuilding(damaged(kBuilding, random), "x");
    if (!building) {
      QVERIFY(!building.error().message.empty());
      continue;
    }
    const Result<RmfLevel> level = findLevel(*building, "");
    if (!level) continue;
    (void)lanesOf(*level, frame);
    const Result<AnchorList> anchors = anchorsOf(*level, "", frame, frame);
    if (!anchors) continue;
    for (const Anchor& anchor : *anchors) QVERIFY(frame.contains(anchor.in_blueprint + Eigen::Vector2d(1e-9, -1e-9)));
  }
}

}  // namespace cad2slam

QTEST_APPLESS_MAIN(cad2slam::RmfBuildingTest)
#include "rmf_building_test.moc"
