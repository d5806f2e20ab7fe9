// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/document/judgement.h"

#include <QTest>

#include <cmath>
#include <limits>

using namespace cad2slam;

namespace {

struct Case {
  AnchorList anchors;
  std::vector<AnchorFit> fits;
};

/// Anchors 1, 2, ... with these residuals, and leave-one-out errors twice as large.
Case withResiduals(const std::vector<double>& residuals) {
  Case result;
  for (std::size_t i = 0; i < residuals.size(); ++i) {
    const AnchorId id = static_cast<AnchorId>(i) + 1;
    result.anchors.push_back(Anchor{.id = id});
    AnchorFit fit;
    fit.id = id;
    fit.residual_m = residuals[i];
    fit.leave_one_out_m = 2.0 * residuals[i];
    result.fits.push_back(fit);
  }
  return result;
}

AnchorClass classOf(const Case& of, AnchorId id, double m_per_px = 0.05) {
  return judgeAnchors(of.anchors, of.fits, {}, m_per_px).at(id).judged;
}

}  // namespace

class JudgementTest : public QObject {
  Q_OBJECT

 private slots:
  void fewAnchorsGetNoVerdict() {
    QCOMPARE(classOf(withResiduals({0.0}), 1), AnchorClass::kPlain);
    QCOMPARE(classOf(withResiduals({0.0, 3.0}), 2), AnchorClass::kPlain);
  }

  void threeAreJudgedByResidualFourByLeaveOneOut() {
    QCOMPARE(classOf(withResiduals({0.08, 0.08, 0.08}), 1), AnchorClass::kOk);
    QCOMPARE(classOf(withResiduals({0.08, 0.08, 0.08, 0.08}), 1), AnchorClass::kLook);
    QCOMPARE(classOf(withResiduals({0.2, 0.2, 0.2, 0.2}), 1), AnchorClass::kBad);
  }

  void limitsGrowWithThePixelsOfTheSlamMap() {
    QCOMPARE(classOf(withResiduals({0.2, 0.2, 0.2, 0.2}), 1, 0.1), AnchorClass::kLook);
    QCOMPARE(classOf(withResiduals({0.2, 0.2, 0.2, 0.2}), 1, 0.2), AnchorClass::kOk);
  }

  void anAnchorThatStandsOutIsBadEvenWithinTheLimits() {
    const Case many = withResiduals({0.01, 0.01, 0.01, 0.01, 0.01, 0.01, 0.01, 0.1});
    QCOMPARE(classOf(many, 8), AnchorClass::kBad);
    QCOMPARE(classOf(many, 1), AnchorClass::kOk);
  }

  void aDisabledAnchorIsACheckAndCountsNowhere() {
    Case of = withResiduals({0.01, 0.01, 0.01, 0.01, 5.0});
    of.anchors[4].enabled = false;
    of.fits[4].used = false;
    const auto judgements = judgeAnchors(of.anchors, of.fits, {}, 0.05);
    QCOMPARE(judgements.at(5).judged, AnchorClass::kDisabled);
    QVERIFY(judgements.at(5).is_check);
    QCOMPARE(judgements.at(5).residual_m.value(), 5.0);
    QVERIFY(!judgements.at(5).leave_one_out_m);
    const AlignmentSummary summary = summarize(of.anchors, of.fits);
    QCOMPARE(summary.used, std::size_t(4));
    QCOMPARE(summary.total, std::size_t(5));
    QCOMPARE(summary.max_residual_m.value(), 0.01);
  }

  void summaryOfKnownNumbers() {
    const AlignmentSummary summary =
        summarize(withResiduals({3.0, 4.0, 0.0, 0.0}).anchors, withResiduals({3.0, 4.0, 0.0, 0.0}).fits);
    QCOMPARE(summary.rms_residual_m.value(), 2.5);
    QCOMPARE(summary.max_residual_m.value(), 4.0);
    QCOMPARE(summary.median_leave_one_out_m.value(), 3.0);
    QVERIFY(!summarize({}, {}).rms_residual_m);
  }

  void anchorsThatAreAllFarOffDoNotPredictEachOther() {
    const auto unpredicted = [](const std::vector<double>& residuals, double m_per_px = 0.05) {
      const Case of = withResiduals(residuals);  // missed by twice as much without themselves
      return isUnpredicted(summarize(of.anchors, of.fits), {}, m_per_px);
    };
    QVERIFY(unpredicted({1.0, 1.1, 0.9, 1.0}));
    QVERIFY2(!unpredicted({1.0, 1.0, 1.0, 1.0}, 0.5), "the limit grows with the pixels");
    QVERIFY(!unpredicted({0.1, 0.1, 0.1, 0.1}));
    QVERIFY2(!unpredicted({0.05, 0.05, 0.05, 5.0}), "one of them is wrong, not all");
    QVERIFY2(!unpredicted({1.0, 1.0, 1.0}), "three say nothing of each other");
  }

  void notANumberIsNoNumber() {
    Case of = withResiduals({0.01, 0.01, 0.01, 0.01});
    of.fits[0].residual_m = std::numeric_limits<double>::quiet_NaN();
    of.fits[1].leave_one_out_m = std::numeric_limits<double>::infinity();
    const auto judgements = judgeAnchors(of.anchors, of.fits, {}, 0.05);
    QVERIFY(!judgements.at(1).residual_m);
    QCOMPARE(judgements.at(1).judged, AnchorClass::kPlain);
    QVERIFY(!judgements.at(2).leave_one_out_m);
    QVERIFY(std::isfinite(summarize(of.anchors, of.fits).rms_residual_m.value()));
  }
};

QTEST_GUILESS_MAIN(JudgementTest)
#include "judgement_test.moc"
