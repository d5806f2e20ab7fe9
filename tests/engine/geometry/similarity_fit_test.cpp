// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include <QtTest>

#include <random>

#include "cad2slam/geometry/similarity_fit.h"

namespace cad2slam {
namespace {

std::vector<PointPair> pairsOf(const Similarity2& truth, std::size_t count, unsigned seed, double noise_m = 0.0) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(-40.0, 40.0);
  std::normal_distribution<double> noise(0.0, 1.0);
  std::vector<PointPair> pairs;
  for (std::size_t k = 0; k < count; ++k) {
    const Eigen::Vector2d source(place(random), place(random));
    const Eigen::Vector2d click(noise(random), noise(random));
    pairs.push_back({source, truth * source + noise_m * click});
  }
  return pairs;
}

bool isSame(const Similarity2& a, const Similarity2& b, double tolerance) {
  return std::abs(a.scale - b.scale) <= tolerance && std::abs(wrapAngle(a.heading - b.heading)) <= tolerance &&
         (a.translation - b.translation).norm() <= 100.0 * tolerance;
}

}  // namespace

class SimilarityFitTest : public QObject {
  Q_OBJECT
 private slots:
  void findsTheTruth_data();
  void findsTheTruth();
  void isTheLeastSquaresMinimum();
  void keepsAFixedScale();
  void onePairIsATranslation();
  void refusesWhatDoesNotDetermineIt();
  void robustFitIgnoresOneFarOutlier();
  void mirrorIsRecognised();
};

void SimilarityFitTest::findsTheTruth_data() {
  QTest::addColumn<double>("heading");
  QTest::newRow("none") << 0.0;
  QTest::newRow("quarter") << kPi / 2;
  QTest::newRow("168 degrees") << 168.0 / 180.0 * kPi;
  QTest::newRow("half") << kPi;
}

void SimilarityFitTest::findsTheTruth() {
  QFETCH(double, heading);
  const Similarity2 truth{1.37, heading, {3.0, -9.0}};
  for (const std::size_t count : {2U, 3U, 30U}) {
    const Result<Similarity2> fit = fitSimilarity(pairsOf(truth, count, 7), std::nullopt);
    QVERIFY(fit.has_value());
    QVERIFY(isSame(*fit, truth, 1e-12));
    QVERIFY(isSame(*fitSimilarityRobust(pairsOf(truth, count, 7), std::nullopt), truth, 1e-9));
  }
}

void SimilarityFitTest::isTheLeastSquaresMinimum() {
  const std::vector<PointPair> pairs = pairsOf({0.8, -1.1, {5.0, 5.0}}, 20, 3, 0.5);
  const Similarity2 fit = *fitSimilarity(pairs, std::nullopt);
  const double best = rmsResidual(fit, pairs);
  for (const double step : {-1e-3, 1e-3}) {
    for (int parameter = 0; parameter < 4; ++parameter) {
      Similarity2 moved = fit;
      if (parameter == 0) moved.scale += step;
      if (parameter == 1) moved.heading += step;
      if (parameter >= 2) moved.translation[parameter - 2] += step;
      QVERIFY(rmsResidual(moved, pairs) > best);
    }
  }
}

void SimilarityFitTest::keepsAFixedScale() {
  const Result<Similarity2> fit = fitSimilarity(pairsOf({1.37, 0.4, {1.0, 2.0}}, 12, 5), 1.0);
  QVERIFY(fit.has_value());
  QCOMPARE(fit->scale, 1.0);
  QVERIFY(std::abs(fit->heading - 0.4) < 1e-12);
}

void SimilarityFitTest::onePairIsATranslation() {
  const Result<Similarity2> fit = fitSimilarity({{{1.0, 2.0}, {10.0, 20.0}}}, 1.0);
  QVERIFY(fit.has_value());
  QVERIFY(isSame(*fit, {1.0, 0.0, {9.0, 18.0}}, 1e-15));
}

void SimilarityFitTest::refusesWhatDoesNotDetermineIt() {
  QCOMPARE(fitSimilarity({}, 1.0).error().code, ErrorCode::kDegenerate);
  QCOMPARE(fitSimilarity({{{1.0, 1.0}, {2.0, 2.0}}}, std::nullopt).error().code, ErrorCode::kDegenerate);
  const std::vector<PointPair> one_place{{{1.0, 1.0}, {2.0, 2.0}}, {{1.0, 1.0}, {3.0, 2.0}}};
  QCOMPARE(fitSimilarity(one_place, std::nullopt).error().code, ErrorCode::kDegenerate);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  QCOMPARE(fitSimilarity({{{nan, 1.0}, {2.0, 2.0}}}, 1.0).error().code, ErrorCode::kMalformed);
}

void SimilarityFitTest::robustFitIgnoresOneFarOutlier() {
  const Similarity2 truth{1.0, 0.7, {3.0, -4.0}};
  std::vector<PointPair> pairs = pairsOf(truth, 20, 11, 0.03);
  const Similarity2 clean = *fitSimilarity(pairs, 1.0);
  pairs[4].target += Eigen::Vector2d(29.0, -3.0);
  const Similarity2 robust = *fitSimilarityRobust(pairs, 1.0);
  for (const PointPair& pair : pairs) QVERIFY((robust * pair.source - clean * pair.source).norm() < 0.1);
  QVERIFY((*fitSimilarity(pairs, 1.0) * pairs[0].source - clean * pairs[0].source).norm() > 0.5);
}

void SimilarityFitTest::mirrorIsRecognised() {
  std::vector<PointPair> pairs = pairsOf({1.0, 0.3, {0.0, 0.0}}, 10, 13);
  for (PointPair& pair : pairs) pair.source.y() = -pair.source.y();
  QVERIFY(rmsResidual(*fitSimilarity(pairs, std::nullopt), pairs) > 1.0);
  const Similarity2 mirrored = *fitMirroredSimilarity(pairs, std::nullopt);
  QVERIFY(isSame(mirrored, {1.0, 0.3, {0.0, 0.0}}, 1e-12));
}

}  // namespace cad2slam

QTEST_GUILESS_MAIN(cad2slam::SimilarityFitTest)
#include "similarity_fit_test.moc"
