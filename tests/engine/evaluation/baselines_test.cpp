// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/evaluation/baselines.h"

#include <Eigen/Dense>

#include <QtTest>

#include <cmath>
#include <random>

using namespace cad2slam;

namespace {

std::vector<Eigen::Vector2d> randomPoints(int count, double reach, const Eigen::Vector2d& center, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-reach, reach);
  std::vector<Eigen::Vector2d> points;
  for (int i = 0; i < count; ++i) {
    const double x = unit(random);
    points.emplace_back(center + Eigen::Vector2d(x, unit(random)));
  }
  return points;
}

double bendingBasis(double r) {
  return r > 0.0 ? r * r * std::log(r) : 0.0;
}

}  // namespace

class BaselinesTest : public QObject {
  Q_OBJECT
 private slots:
  void affineReproducesAnAffineMap_data() {
    QTest::addColumn<double>("offset");
    QTest::newRow("near the origin") << 0.0;
    QTest::newRow("far away") << 1e5;
  }
  void affineReproducesAnAffineMap() {
    QFETCH(double, offset);
    Eigen::Matrix2d linear;
    linear << 0.3, -1.2, 1.1, 0.4;
    std::vector<PointPair> pairs;
    for (const Eigen::Vector2d& point : randomPoints(9, 20.0, {offset, -offset}, 1)) {
      pairs.push_back({point, linear * point + Eigen::Vector2d(3.0, -8.0)});
    }
    const Result<Affine2> affine = fitAffine(pairs);
    QVERIFY(affine);
    QVERIFY((affine->linear - linear).norm() < 1e-8);
    for (const PointPair& pair : pairs) QVERIFY((*affine * pair.source - pair.target).norm() < 1e-6);
  }

  void affineIsTheLeastSquaresSolution() {
    std::vector<PointPair> pairs;
    const auto sources = randomPoints(12, 10.0, {4.0, 2.0}, 2);
    const auto targets = randomPoints(12, 10.0, {-1.0, 5.0}, 3);
    Eigen::MatrixXd design(12, 3);
    Eigen::MatrixXd observed(12, 2);
    for (int i = 0; i < 12; ++i) {
      pairs.push_back({sources[static_cast<std::size_t>(i)], targets[static_cast<std::size_t>(i)]});
      design.row(i) << pairs.back().source.transpose(), 1.0;
      observed.row(i) = pairs.back().target.transpose();
    }
    const Eigen::MatrixXd expected = design.colPivHouseholderQr().solve(observed);
    const Result<Affine2> affine = fitAffine(pairs);
    QVERIFY(affine);
    QVERIFY((affine->linear - expected.topRows(2).transpose()).norm() < 1e-10);
    QVERIFY((affine->translation - expected.row(2).transpose()).norm() < 1e-10);
  }

  void splineMeetsEveryPair() {
    std::vector<PointPair> pairs;
    const auto sources = randomPoints(40, 50.0, {1e4, -300.0}, 4);
    const auto targets = randomPoints(40, 50.0, {7.0, 7.0}, 5);
    for (std::size_t i = 0; i < sources.size(); ++i) pairs.push_back({sources[i], targets[i]});
    const Result<ThinPlateSpline> spline = ThinPlateSpline::fit(pairs);
    QVERIFY(spline);
    for (const PointPair& pair : pairs) QVERIFY((*spline * pair.source - pair.target).norm() < 1e-6);
  }

  void splineOfAnAffineMapIsThatMap() {
    Eigen::Matrix2d linear;
    linear << 1.1, 0.2, -0.3, 0.9;
    std::vector<PointPair> pairs;
    for (const Eigen::Vector2d& point : randomPoints(7, 20.0, {0.0, 0.0}, 6)) pairs.push_back({point, linear * point});
    const Result<ThinPlateSpline> spline = ThinPlateSpline::fit(pairs);
    QVERIFY(spline);
    for (const Eigen::Vector2d& point : randomPoints(20, 60.0, {5.0, 5.0}, 7)) {
      QVERIFY((*spline * point - linear * point).norm() < 1e-8);
    }
  }

  /// Four corners of a square, alternately lifted: by symmetry f = +-U-combination, known in closed form.
  void splineOfASaddle() {
    const std::vector<Eigen::Vector2d> corners = {{1, 1}, {-1, 1}, {-1, -1}, {1, -1}};
    std::vector<PointPair> pairs;
    for (std::size_t i = 0; i < 4; ++i) pairs.push_back({corners[i], {i % 2 == 0 ? 1.0 : -1.0, 0.0}});
    const Result<ThinPlateSpline> spline = ThinPlateSpline::fit(pairs);
    QVERIFY(spline);
    const double weight = 1.0 / (bendingBasis(std::sqrt(8.0)) - 2.0 * bendingBasis(2.0));
    for (const Eigen::Vector2d& point : randomPoints(30, 3.0, {0.0, 0.0}, 8)) {
      double expected = 0.0;
      for (std::size_t i = 0; i < 4; ++i) {
        expected += (i % 2 == 0 ? weight : -weight) * bendingBasis((point - corners[i]).norm());
      }
      QVERIFY(std::abs((*spline * point).x() - expected) < 1e-9);
      QVERIFY(std::abs((*spline * point).y()) < 1e-9);
    }
  }

  void splineDoesNotDependOnUnitsOrPlace() {
    std::vector<PointPair> metres;
    std::vector<PointPair> moved;
    const auto sources = randomPoints(15, 30.0, {0.0, 0.0}, 9);
    const auto targets = randomPoints(15, 30.0, {0.0, 0.0}, 10);
    const Eigen::Vector2d shift(1000.0, 2000.0);
    for (std::size_t i = 0; i < sources.size(); ++i) {
      metres.push_back({sources[i], targets[i]});
      moved.push_back({sources[i] * 100.0 + shift, targets[i]});
    }
    const auto a = ThinPlateSpline::fit(metres);
    const auto b = ThinPlateSpline::fit(moved);
    QVERIFY(a && b);
    for (const Eigen::Vector2d& point : randomPoints(20, 40.0, {0.0, 0.0}, 11)) {
      QVERIFY((*a * point - *b * Eigen::Vector2d(point * 100.0 + shift)).norm() < 1e-6);
    }
  }

  void sameSourceTwiceIsTheMean() {
    std::vector<PointPair> pairs = {{{0, 0}, {0, 0}}, {{1, 0}, {1, 0}}, {{0, 1}, {0, 1}}, {{1, 1}, {1, 1}}};
    pairs.push_back({{1, 1}, {3, 1}});
    const Result<ThinPlateSpline> spline = ThinPlateSpline::fit(pairs);
    QVERIFY(spline);
    QVERIFY((*spline * Eigen::Vector2d(1, 1) - Eigen::Vector2d(2, 1)).norm() < 1e-9);
  }

  void degenerateSetsAreRefused() {
    const std::vector<PointPair> two = {{{0, 0}, {0, 0}}, {{1, 0}, {1, 0}}};
    const std::vector<PointPair> line = {{{0, 0}, {0, 0}}, {{1, 2}, {1, 0}}, {{2, 4}, {5, 0}}, {{-3, -6}, {0, 3}}};
    const std::vector<PointPair> one_place(5, PointPair{{2, 2}, {1, 1}});
    const std::vector<PointPair> not_finite = {{{0, 0}, {0, 0}}, {{1, 0}, {1, 0}}, {{std::nan(""), 1}, {0, 0}}};
    for (const auto& pairs : {std::vector<PointPair>{}, two, line, one_place, not_finite}) {
      const Result<Affine2> affine = fitAffine(pairs);
      const Result<ThinPlateSpline> spline = ThinPlateSpline::fit(pairs);
      QVERIFY(!affine && affine.error().code == ErrorCode::kDegenerate);
      QVERIFY(!spline && spline.error().code == ErrorCode::kDegenerate);
    }
  }
};

QTEST_APPLESS_MAIN(BaselinesTest)
#include "baselines_test.moc"
