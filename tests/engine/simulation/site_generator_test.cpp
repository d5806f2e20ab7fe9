// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/simulation/site_generator.h"

#include <Eigen/LU>
#include <opencv2/core.hpp>

#include <QtTest>

#include <algorithm>
#include <set>

using namespace cad2slam;

class SiteGeneratorTest : public QObject {
  Q_OBJECT
 private slots:
  void sameSeedSameSite();
  void randomSitesAreSound();
  void randomSitesVary();
  void anchorsFollowTheTruth();
  void clustersAreDenserThanSpreads();
  void sampledTruthIsGoodToMillimetres();
  void outliersAreFarOff();
  void refusals();
};

void SiteGeneratorTest::sameSeedSameSite() {
  const Result<GeneratedSite> a = generateSite(randomSiteRecipe(5));
  const Result<GeneratedSite> b = generateSite(randomSiteRecipe(5));
  QVERIFY(a && b);
  QVERIFY(a->anchors == b->anchors);
  QCOMPARE(cv::norm(a->building.blueprint.states(), b->building.blueprint.states(), cv::NORM_INF), 0.0);
  const Result<GeneratedSite> other = generateSite(randomSiteRecipe(6));
  QVERIFY(other && other->anchors != a->anchors);
}

void SiteGeneratorTest::randomSitesAreSound() {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const SiteRecipe recipe = randomSiteRecipe(seed);
    const Result<GeneratedSite> site = generateSite(recipe);
    QVERIFY2(site, site ? "" : site.error().message.c_str());
    QVERIFY(site->anchors.size() >= 4);
    QVERIFY(site->building.blueprint.frame().width() < 4000);
    QVERIFY(site->warp.strength() > 0.02);
    for (const Eigen::Vector2d& place : freePlaces(site->building.plan, 1.3)) {
      const double area = site->warp.jacobian(place).determinant();
      QVERIFY2(area > 0.65 && area < 1.45, qPrintable(QString("seed %1: %2").arg(seed).arg(area)));
    }
    for (const Anchor& anchor : site->anchors) {
      QVERIFY(anchor.in_slam.allFinite());
      QVERIFY(site->building.blueprint.frame().contains(anchor.in_blueprint));
    }
  }
}

void SiteGeneratorTest::randomSitesVary() {
  std::set<SiteKind> kinds;
  std::set<AnchorLayout> layouts;
  double smallest = 1e9;
  double largest = 0.0;
  int to_scale = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const SiteRecipe recipe = randomSiteRecipe(seed);
    kinds.insert(recipe.building.plan.kind);
    layouts.insert(recipe.anchors.layout);
    smallest = std::min(smallest, recipe.building.plan.size_m.maxCoeff());
    largest = std::max(largest, recipe.building.plan.size_m.maxCoeff());
    to_scale += std::abs(recipe.building.plan_scale - 1.0) < 0.01 ? 1 : 0;
  }
  QCOMPARE(kinds.size(), std::size_t{4});
  QCOMPARE(layouts.size(), std::size_t{4});
  QVERIFY(smallest < 12.0);
  QVERIFY(largest > 90.0);
  QVERIFY(to_scale > 60 && to_scale < 160);
}

void SiteGeneratorTest::anchorsFollowTheTruth() {
  SiteRecipe recipe = randomSiteRecipe(21);
  recipe.anchors = {40, AnchorLayout::kRandom, 0.0, 0.0, 0.0, 0, 0.0};
  const Result<GeneratedSite> site = generateSite(recipe);
  QVERIFY(site);
  for (const Anchor& anchor : site->anchors) {
    const Pose2 truth = site->slamFromBlueprint({anchor.in_blueprint, 0.0});
    QVERIFY((truth.translation - anchor.in_slam).norm() < 1e-9);
  }
}

void SiteGeneratorTest::clustersAreDenserThanSpreads() {
  const auto mean_nearest = [](AnchorLayout layout) {
    SiteRecipe recipe = randomSiteRecipe(2);
    recipe.building.plan = {SiteKind::kOffice, {60.0, 40.0}, CorridorShape::kU};
    recipe.anchors.layout = layout;
    recipe.anchors.count = 12;
    const AnchorList anchors = generateSite(recipe)->anchors;
    double sum = 0.0;
    for (const Anchor& a : anchors) {
      double nearest = 1e9;
      for (const Anchor& b : anchors) {
        if (a.id != b.id) nearest = std::min(nearest, (a.in_blueprint - b.in_blueprint).norm());
      }
      sum += nearest / static_cast<double>(anchors.size());
    }
    return sum;
  };
  QVERIFY(mean_nearest(AnchorLayout::kSpread) > 2.0 * mean_nearest(AnchorLayout::kClustered));
}

void SiteGeneratorTest::sampledTruthIsGoodToMillimetres() {
  for (const std::uint64_t seed : {1U, 8U, 17U}) {
    const Result<GeneratedSite> site = generateSite(randomSiteRecipe(seed));
    QVERIFY(site);
    const Result<TrueWarp> truth = sampleTrueWarp(site->building, site->warp);
    QVERIFY(truth);
    const double scale = site->recipe.building.plan_scale;
    for (const Eigen::Vector2d& place : freePlaces(site->building.plan, 0.7)) {
      const Pose2 in_blueprint = site->building.blueprint_from_plan * Pose2{place, 0.0};
      const auto read = truth->slamFromBlueprint(in_blueprint);
      QVERIFY(read.has_value());
      const Pose2 exact = site->slamFromBlueprint(in_blueprint);
      QVERIFY((read->translation - exact.translation).norm() < 0.004 * std::max(1.0, scale * scale));
      QVERIFY(std::abs(wrapAngle(read->heading - exact.heading)) < 0.003 * std::max(1.0, scale * scale));
    }
  }
}

void SiteGeneratorTest::outliersAreFarOff() {
  SiteRecipe recipe = randomSiteRecipe(12);
  recipe.anchors.count = 20;
  recipe.anchors.outliers = 1;
  recipe.anchors.outlier_m = 30.0;
  const Result<GeneratedSite> site = generateSite(recipe);
  QVERIFY(site);
  const auto far_off = std::count_if(site->anchors.begin(), site->anchors.end(), [&](const Anchor& anchor) {
    return (site->slamFromBlueprint({anchor.in_blueprint, 0.0}).translation - anchor.in_slam).norm() > 25.0;
  });
  QCOMPARE(far_off, 1);
}

void SiteGeneratorTest::refusals() {
  SiteRecipe recipe = randomSiteRecipe(1);
  recipe.building.plan_scale = 0.0;
  QVERIFY(!generateSite(recipe));
  recipe = randomSiteRecipe(1);
  recipe.building.plan.size_m = {3.0, 20.0};
  QVERIFY(!generateSite(recipe));
  recipe = randomSiteRecipe(1);
  recipe.building.resolution_m_per_px = 1e-5;
  QVERIFY(!generateSite(recipe));
  const Result<GeneratedSite> site = generateSite(randomSiteRecipe(1));
  QVERIFY(!sampleTrueWarp(site->building, site->warp, 0.0));
  QVERIFY(!sampleTrueWarp(site->building, site->warp, 1e-6));
}

QTEST_APPLESS_MAIN(SiteGeneratorTest)
#include "site_generator_test.moc"
