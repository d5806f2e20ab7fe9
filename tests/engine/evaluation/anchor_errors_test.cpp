// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/evaluation/anchor_errors.h"

#include <QtTest>

#include <cmath>

#include "evaluation_site.h"

using namespace cad2slam;

namespace {

const MethodErrors& find(const std::vector<MethodErrors>& methods, AlignmentMethod method) {
  for (const MethodErrors& errors : methods) {
    if (errors.method == method) return errors;
  }
  qFatal("method is missing");
}

}  // namespace

class AnchorErrorsTest : public QObject {
  Q_OBJECT
 private slots:
  void rigidMotionIsPredictedExactly() {
    const test::EvaluationSite made = test::makeEvaluationSite(test::rigidWarp(), 12, 0.0);
    const Result<LeaveOneOut> loo = evaluateLeaveOneOut(made.mesh, made.site.anchors, {});
    QVERIFY(loo);
    QCOMPARE(loo->anchors.size(), made.site.anchors.size());
    for (const MethodErrors& errors : loo->methods) {
      QCOMPARE(errors.errors_m.size(), made.site.anchors.size());
      QVERIFY2(errors.statistics.max < 1e-4, methodKey(errors.method).c_str());
    }
  }

  void agreesWithSolvingByHand() {
    const test::EvaluationSite made = test::makeEvaluationSite(test::bentWarp(), 9);
    const Result<LeaveOneOut> loo = evaluateLeaveOneOut(made.mesh, made.site.anchors, {});
    QVERIFY(loo);
    for (std::size_t left_out = 0; left_out < made.site.anchors.size(); ++left_out) {
      AnchorList rest = made.site.anchors;
      rest[left_out].enabled = false;
      const Anchor& tested = made.site.anchors[left_out];
      for (const AlignmentMethod method : {AlignmentMethod::kSimilarity, AlignmentMethod::kStretch}) {
        const PointFunction function = *MethodFitter(made.mesh).fit(method, rest);
        const double expected = (function(tested.in_blueprint) - tested.in_slam).norm();
        QVERIFY(std::abs(find(loo->methods, method).errors_m[left_out] - expected) < 1e-6);
      }
    }
  }

  /// The solver's residuals without re-solving are a linearisation of what this module does by force.
  void agreesWithTheShortcutOfOneFactorisation() {
    const test::EvaluationSite made = test::makeEvaluationSite(test::bentWarp(), 20);
    const Result<LeaveOneOut> loo = evaluateLeaveOneOut(made.mesh, made.site.anchors, {});
    const Result<Solution> solution = MeshSolver(made.mesh).solve(made.site.anchors, defaultSettings(Model::kStretch));
    QVERIFY(loo && solution);
    double shortcut = 0.0;
    for (const AnchorFit& fit : solution->anchors) {
      shortcut += fit.leave_one_out_m / static_cast<double>(solution->anchors.size());
    }
    const double by_force = find(loo->methods, AlignmentMethod::kStretch).statistics.mean;
    QVERIFY2(std::abs(shortcut - by_force) < 0.25 * by_force,
             qPrintable(QString("%1 and %2").arg(shortcut).arg(by_force)));
  }

  void threadsDoNotChangeTheResult() {
    const test::EvaluationSite made = test::makeEvaluationSite(test::bentWarp(), 8);
    EvaluationOptions one;
    one.threads = 1;
    EvaluationOptions three;
    three.threads = 3;
    const Result<LeaveOneOut> a = evaluateLeaveOneOut(made.mesh, made.site.anchors, one);
    const Result<LeaveOneOut> b = evaluateLeaveOneOut(made.mesh, made.site.anchors, three);
    QVERIFY(a && b);
    for (std::size_t method = 0; method < a->methods.size(); ++method) {
      for (std::size_t i = 0; i < a->anchors.size(); ++i) {
        QVERIFY(std::abs(a->methods[method].errors_m[i] - b->methods[method].errors_m[i]) < 1e-7);
      }
    }
  }

  void curveIsSeededAndCountsItsTests() {
    const test::EvaluationSite made = test::makeEvaluationSite(test::bentWarp(), 14);
    EvaluationOptions options;
    options.methods = {AlignmentMethod::kSimilarity, AlignmentMethod::kThinPlateSpline};
    const CurveOptions curve{{4, 8, 14, 30}, 5, 3};
    const Result<LearningCurve> a = evaluateLearningCurve(made.mesh, made.site.anchors, curve, options);
    const Result<LearningCurve> b = evaluateLearningCurve(made.mesh, made.site.anchors, curve, options);
    const Result<LearningCurve> other = evaluateLearningCurve(made.mesh, made.site.anchors, {{4, 8}, 5, 4}, options);
    QVERIFY(a && b && other);
    QCOMPARE(a->points.size(), std::size_t{2});  // 14 and 30 leave nothing to test
    QCOMPARE(a->points[0].methods[0].errors_m.size(), std::size_t{5 * 10});
    QCOMPARE(a->points[1].methods[0].errors_m.size(), std::size_t{5 * 6});
    QCOMPARE(a->points[0].methods[0].errors_m, b->points[0].methods[0].errors_m);
    QVERIFY(a->points[0].methods[0].errors_m != other->points[0].methods[0].errors_m);
  }

  void moreAnchorsAreBetterOnABentSite() {
    const test::EvaluationSite made = test::makeEvaluationSite(test::bentWarp(), 40);
    EvaluationOptions options;
    options.methods = {AlignmentMethod::kStretch};
    const Result<LearningCurve> curve = evaluateLearningCurve(made.mesh, made.site.anchors, {{4, 25}, 4, 1}, options);
    QVERIFY(curve);
    QVERIFY(curve->points[1].methods[0].statistics.mean < curve->points[0].methods[0].statistics.mean);
  }

  void progressCountsToTheEnd() {
    const test::EvaluationSite made = test::makeEvaluationSite(test::rigidWarp(), 6);
    EvaluationOptions options;
    options.methods = {AlignmentMethod::kSimilarity, AlignmentMethod::kAffine};
    std::size_t last = 0;
    options.on_progress = [&](std::size_t done, std::size_t total) {
      QCOMPARE(total, std::size_t{12});
      QCOMPARE(done, last + 1);
      last = done;
    };
    QVERIFY(evaluateLeaveOneOut(made.mesh, made.site.anchors, options));
    QCOMPARE(last, std::size_t{12});
  }

  void tooFewAnchors() {
    test::EvaluationSite made = test::makeEvaluationSite(test::rigidWarp(), 3);
    QVERIFY(evaluateLeaveOneOut(made.mesh, made.site.anchors, {}));
    made.site.anchors[0].enabled = false;
    const Result<LeaveOneOut> loo = evaluateLeaveOneOut(made.mesh, made.site.anchors, {});
    QVERIFY(!loo);
    QCOMPARE(loo.error().code, ErrorCode::kDegenerate);
    QVERIFY(QString::fromStdString(loo.error().message).contains("here are 2"));
    QVERIFY(!evaluateLearningCurve(made.mesh, {}, {}, {}));
    QVERIFY(!evaluateLearningCurve(made.mesh, test::makeEvaluationSite(test::rigidWarp(), 9).site.anchors, {{1}, 3, 1},
                                   {}));
  }
};

QTEST_APPLESS_MAIN(AnchorErrorsTest)
#include "anchor_errors_test.moc"
