// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/solver/thin_plate_fit.h"

#include <QTest>

#include <functional>
#include <optional>
#include <random>
#include <vector>

#include "cad2slam/evaluation/baselines.h"

using namespace cad2slam;
using Eigen::Vector2d;

namespace {

Vector2d bent(const Vector2d& p) {
  return {3.0 + 0.98 * p.x() - 0.02 * p.y(), -1.0 + 0.03 * p.x() + p.y() + 0.004 * p.x() * p.x()};
}

std::vector<PointPair> pairs(std::size_t count, double noise_m, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(-20.0, 20.0);
  std::normal_distribution<double> noise(0.0, 1.0);
  std::vector<PointPair> made;
  for (std::size_t i = 0; i < count; ++i) {
    const Vector2d source(place(random), 0.6 * place(random));
    made.push_back({source, bent(source) + noise_m * Vector2d(noise(random), noise(random))});
  }
  return made;
}

double meanError(const std::vector<PointPair>& truth, const std::function<Vector2d(const Vector2d&)>& map) {
  double sum = 0.0;
  for (const PointPair& pair : truth) sum += (map(pair.source) - pair.target).norm();
  return sum / static_cast<double>(truth.size());
}

}  // namespace

class ThinPlateFitTest : public QObject {
  Q_OBJECT

 private slots:
  void affineMapsAreExact();
  void withoutNoiseItInterpolates();
  void noiseIsSmoothedAway();
  void leaveOneOutEqualsFittingAgain();
  void jacobianIsTheDerivative();
  void aWrongPairLosesItsWeight();
  void sigmaGrowsAwayFromThePairs();
  void refusesWhatSaysTooLittle();
};

void ThinPlateFitTest::affineMapsAreExact() {
  std::vector<PointPair> exact = pairs(12, 0.0, 1);
  Eigen::Matrix2d linear;
  linear << 0.9, 0.2, -0.3, 1.1;
  for (PointPair& pair : exact) pair.target = linear * pair.source + Vector2d(5.0, 6.0);
  const auto fit = ThinPlateFit::create(exact, 1.0);
  QVERIFY(fit.has_value());
  for (const PointPair& pair : pairs(50, 0.0, 2)) {
    QVERIFY((*fit * pair.source - linear * pair.source - Vector2d(5.0, 6.0)).norm() < 1e-9);
    QVERIFY((fit->at(pair.source).jacobian - linear).norm() < 1e-9);
  }
}

void ThinPlateFitTest::withoutNoiseItInterpolates() {
  const std::vector<PointPair> exact = pairs(40, 0.0, 3);
  const auto fit = ThinPlateFit::create(exact, 1.0);
  const auto spline = ThinPlateSpline::fit(exact);
  QVERIFY(fit && spline);
  for (const PointPair& pair : pairs(50, 0.0, 4)) {
    QVERIFY((*fit * pair.source - *spline * pair.source).norm() < 0.02);
  }
}

void ThinPlateFitTest::noiseIsSmoothedAway() {
  double smoothed = 0.0;
  double interpolated = 0.0;
  const std::vector<PointPair> truth = pairs(200, 0.0, 5);
  for (unsigned seed = 10; seed < 20; ++seed) {
    const std::vector<PointPair> noisy = pairs(40, 0.1, seed);
    const auto fit = ThinPlateFit::create(noisy, 1.0);
    const auto spline = ThinPlateSpline::fit(noisy);
    QVERIFY(fit && spline);
    smoothed += meanError(truth, [&](const Vector2d& p) { return *fit * p; });
    interpolated += meanError(truth, [&](const Vector2d& p) { return *spline * p; });
  }
  QVERIFY2(smoothed < 0.75 * interpolated, qPrintable(QString("%1 against %2").arg(smoothed).arg(interpolated)));
}

void ThinPlateFitTest::leaveOneOutEqualsFittingAgain() {
  const std::vector<PointPair> all = pairs(25, 0.3, 6);
  const auto fit = ThinPlateFit::create(all, std::nullopt);
  QVERIFY(fit.has_value());
  // lambda is in units of the scaled sources, whose scale one pair changes a little.
  for (std::size_t i = 0; i < all.size(); ++i) {
    std::vector<PointPair> others = all;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
    const auto without = ThinPlateFit::create(others, std::nullopt, fit->lambda());
    QVERIFY(without.has_value());
    const Vector2d residual = *without * all[i].source - all[i].target;
    QVERIFY2((residual - fit->leaveOneOut()[i]).norm() < 0.02 * residual.norm() + 0.01,
             qPrintable(QString("pair %1: %2 m").arg(i).arg((residual - fit->leaveOneOut()[i]).norm())));
  }
}

void ThinPlateFitTest::jacobianIsTheDerivative() {
  const auto fit = ThinPlateFit::create(pairs(30, 0.2, 7), 1.0);
  QVERIFY(fit.has_value());
  constexpr double kStep = 1e-5;
  for (const PointPair& pair : pairs(20, 0.0, 8)) {
    for (int axis = 0; axis < 2; ++axis) {
      const Vector2d step = kStep * Vector2d::Unit(axis);
      const Vector2d slope = (*fit * (pair.source + step) - *fit * (pair.source - step)) / (2.0 * kStep);
      QVERIFY((slope - fit->at(pair.source).jacobian.col(axis)).norm() < 1e-6);
    }
  }
}

void ThinPlateFitTest::aWrongPairLosesItsWeight() {
  std::vector<PointPair> with_outlier = pairs(30, 0.05, 9);
  with_outlier[7].target += Vector2d(8.0, -5.0);
  const auto fit = ThinPlateFit::create(with_outlier, 1.0);
  QVERIFY(fit.has_value());
  QVERIFY(fit->weights()[7] < 0.05);
  const auto truth = pairs(100, 0.0, 11);
  QVERIFY(meanError(truth, [&](const Vector2d& p) { return *fit * p; }) < 0.3);
}

void ThinPlateFitTest::sigmaGrowsAwayFromThePairs() {
  const std::vector<PointPair> noisy = pairs(30, 0.1, 12);
  const auto fit = ThinPlateFit::create(noisy, 1.0);
  QVERIFY(fit.has_value());
  const double near = fit->sigma(noisy[3].source);
  QVERIFY(near > 0.0);
  QVERIFY(fit->sigma({60.0, 40.0}) > 3.0 * near);
}

void ThinPlateFitTest::refusesWhatSaysTooLittle() {
  QVERIFY(!ThinPlateFit::create(pairs(4, 0.0, 1), 1.0));
  QVERIFY(!ThinPlateFit::create(pairs(ThinPlateFit::kMostPairs + 1, 0.0, 1), 1.0));
  std::vector<PointPair> line = pairs(20, 0.0, 1);
  for (PointPair& pair : line) pair.source.y() *= 0.05;
  QVERIFY(!ThinPlateFit::create(line, 1.0));
  for (PointPair& pair : line) pair.source = {1.0, 2.0};
  QVERIFY(!ThinPlateFit::create(line, 1.0));
}

QTEST_APPLESS_MAIN(ThinPlateFitTest)
#include "thin_plate_fit_test.moc"
