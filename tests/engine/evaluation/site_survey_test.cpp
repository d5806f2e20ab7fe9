// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/evaluation/site_survey.h"

#include <QtTest>

#include <cmath>

using namespace cad2slam;

class SiteSurveyTest : public QObject {
  Q_OBJECT
 private slots:
  void sitesAreMeasured() {
    SurveyOptions survey;
    survey.sites = 4;
    survey.first_seed = 3;
    survey.cell_size_m = 2.0;
    const Result<SiteSurvey> result = surveySites(survey, {});
    QVERIFY(result);
    QCOMPARE(result->sites.size(), std::size_t{4});
    for (std::size_t i = 0; i < result->sites.size(); ++i) {
      QCOMPARE(result->sites[i].seed, std::uint64_t{3 + i});
      QCOMPARE(result->sites[i].mean_error_m.size(), kAllMethods.size());
      for (const double error : result->sites[i].mean_error_m) QVERIFY(std::isfinite(error) && error > 0.0);
    }
    const Result<SiteSurvey> again = surveySites(survey, {});
    QVERIFY(again && std::abs(again->sites[2].mean_error_m[5] - result->sites[2].mean_error_m[5]) < 1e-7);
  }

  void numberOfAnchorsCanBeSet() {
    SurveyOptions survey;
    survey.sites = 2;
    survey.anchors = 7;
    EvaluationOptions options;
    options.methods = {AlignmentMethod::kSimilarity};
    const Result<SiteSurvey> result = surveySites(survey, options);
    QVERIFY(result);
    for (const SurveyedSite& site : result->sites) QCOMPARE(site.anchors, std::size_t{7});
  }

  void summaries() {
    SiteSurvey survey;
    survey.methods = {AlignmentMethod::kSimilarity, AlignmentMethod::kAffine, AlignmentMethod::kStretch};
    survey.sites.resize(2);
    survey.sites[0].mean_error_m = {0.4, 0.2, 0.1};
    survey.sites[1].mean_error_m = {0.1, 0.4, 0.2};
    const std::vector<AlignmentMethod> others = {AlignmentMethod::kSimilarity, AlignmentMethod::kAffine};
    QVERIFY(std::abs(survey.ratioToBest(AlignmentMethod::kStretch, others) - 1.0) < 1e-12);  // 1/2 and 2
    QVERIFY(std::abs(survey.geometricMean(AlignmentMethod::kSimilarity) - 0.2) < 1e-12);
    QCOMPARE(survey.shareWithin(AlignmentMethod::kStretch, others, 1.05), 0.5);
    QCOMPARE(survey.shareWithin(AlignmentMethod::kStretch, others, 2.5), 1.0);
  }

  void noSitesIsAnError() {
    SurveyOptions survey;
    survey.sites = 0;
    QVERIFY(!surveySites(survey, {}));
  }
};

QTEST_APPLESS_MAIN(SiteSurveyTest)
#include "site_survey_test.moc"
