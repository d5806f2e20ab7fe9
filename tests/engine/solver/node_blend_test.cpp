// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/solver/node_blend.h"

#include <QtTest>

#include <numeric>
#include <random>

#include "support/synthetic_buildings.h"

namespace cad2slam {
namespace {

using Eigen::Vector2d;

/// The weighted mean of the nodes' centres.
Vector2d middleOf(const Mesh& mesh, const NodeBlend& blend) {
  Vector2d middle = Vector2d::Zero();
  for (std::size_t k = 0; k < blend.count; ++k) middle += blend.weights[k] * mesh.centers()[blend.nodes[k]];
  return middle;
}

}  // namespace

class NodeBlendTest : public QObject {
  Q_OBJECT
 private slots:
  void init() { mesh_ = testing::meshOf(testing::uShapedCorridor(), 0.5); }
  void nearestIsTheNearest();
  void weightsSumUpToOne();
  void insideTheBlendIsTheQuery();
  void weightsDoNotJump();

 private:
  std::shared_ptr<const Mesh> mesh_;
};

void NodeBlendTest::nearestIsTheNearest() {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> part(-5.0, 22.0);
  for (int round = 0; round < 300; ++round) {
    const Vector2d place(part(random), part(random));
    const NodeBlend blend = nearestNodeBlend(*mesh_, place);
    QCOMPARE(blend.count, std::size_t{1});
    QCOMPARE(blend.weights[0], 1.0);
    const double found = (mesh_->centers()[blend.nodes[0]] - place).norm();
    for (const Vector2d& center : mesh_->centers()) QVERIFY((center - place).norm() >= found);
  }
}

void NodeBlendTest::weightsSumUpToOne() {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> part(-50.0, 60.0);
  for (int round = 0; round < 2000; ++round) {
    const Vector2d place = round % 2 == 0 ? testing::randomPlace(*mesh_, random) : Vector2d(part(random), part(random));
    const NodeBlend blend = smoothBlend(*mesh_, place);
    QVERIFY(blend.count >= 1 && blend.count <= NodeBlend::kCapacity);
    double sum = 0.0;
    for (std::size_t k = 0; k < blend.count; ++k) {
      QVERIFY(blend.weights[k] >= 0.0);
      sum += blend.weights[k];
    }
    QVERIFY(std::abs(sum - 1.0) < 1e-12);
  }
}

void NodeBlendTest::insideTheBlendIsTheQuery() {
  // Where all nine nodes exist, B-splines reproduce linear functions.
  std::mt19937 random(3);
  int full = 0;
  for (int round = 0; round < 2000; ++round) {
    const Vector2d place = testing::randomPlace(*mesh_, random);
    const NodeBlend blend = smoothBlend(*mesh_, place);
    if (blend.count < NodeBlend::kCapacity) continue;
    ++full;
    QVERIFY((middleOf(*mesh_, blend) - place).norm() < 1e-12);
  }
  QVERIFY(full > 500);
}

void NodeBlendTest::weightsDoNotJump() {
  std::mt19937 random(4);
  for (int round = 0; round < 5000; ++round) {
    const Vector2d place = testing::randomPlace(*mesh_, random);
    const Vector2d next = place + Vector2d(0.7e-4, -0.7e-4);
    const double step =
        (middleOf(*mesh_, smoothBlend(*mesh_, next)) - middleOf(*mesh_, smoothBlend(*mesh_, place))).norm();
    QVERIFY(step < 3e-4);
  }
}

}  // namespace cad2slam

QTEST_GUILESS_MAIN(cad2slam::NodeBlendTest)
#include "node_blend_test.moc"
