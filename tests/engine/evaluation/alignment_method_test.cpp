// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/evaluation/alignment_method.h"

#include <QtTest>

#include <set>

#include "evaluation_site.h"

using namespace cad2slam;

class AlignmentMethodTest : public QObject {
  Q_OBJECT
 private slots:
  void keysAreThoseOfTheReports() {
    std::set<std::string> keys;
    for (const AlignmentMethod method : kAllMethods) keys.insert(methodKey(method));
    QVERIFY((keys ==
             std::set<std::string>{"affine", "rigid", "rigid_scaled", "similarity", "stretch", "thin_plate_spline"}));
  }

  void everyMethodFindsARigidMotion() {
    const test::EvaluationSite made = test::makeEvaluationSite(test::rigidWarp(), 10, 0.0);
    MethodFitter fitter(made.mesh);
    for (const AlignmentMethod method : kAllMethods) {
      const Result<PointFunction> function = fitter.fit(method, made.site.anchors);
      QVERIFY(function);
      for (const Eigen::Vector2d& place : freePlaces(made.site.building.plan, 2.0)) {
        const Pose2 in_blueprint = made.site.building.blueprint_from_plan * Pose2{place, 0.0};
        const double error =
            ((*function)(in_blueprint.translation) - made.site.slamFromBlueprint(in_blueprint).translation).norm();
        QVERIFY2(error < 1e-5, methodKey(method).c_str());
      }
    }
  }

  void disabledAnchorsAreNotUsed() {
    test::EvaluationSite made = test::makeEvaluationSite(test::rigidWarp(), 10, 0.0);
    made.site.anchors[3].in_slam += Eigen::Vector2d(20.0, 0.0);
    made.site.anchors[3].enabled = false;
    MethodFitter fitter(made.mesh);
    const Anchor& good = made.site.anchors[5];
    for (const AlignmentMethod method : kAllMethods) {
      const Result<PointFunction> function = fitter.fit(method, made.site.anchors);
      QVERIFY(function);
      QVERIFY(((*function)(good.in_blueprint) - good.in_slam).norm() < 1e-5);
    }
  }

  void anchorsOnALineFallBackToTheSimilarity() {
    const test::EvaluationSite made = test::makeEvaluationSite(test::rigidWarp(), 10);
    AnchorList line;
    for (int i = 0; i < 4; ++i) {
      Anchor anchor;
      anchor.id = i + 1;
      anchor.in_blueprint = {5.0 * i, 2.0};
      anchor.in_slam = {2.0, 5.0 * i};
      line.push_back(anchor);
    }
    MethodFitter fitter(made.mesh);
    const Eigen::Vector2d place(3.0, 7.0);
    const Eigen::Vector2d expected = (*fitter.fit(AlignmentMethod::kSimilarity, line))(place);
    for (const AlignmentMethod method : {AlignmentMethod::kAffine, AlignmentMethod::kThinPlateSpline}) {
      QVERIFY(((*fitter.fit(method, line))(place)-expected).norm() < 1e-12);
    }
  }

  void noAnchorIsAnError() {
    const test::EvaluationSite made = test::makeEvaluationSite(test::rigidWarp(), 10);
    MethodFitter fitter(made.mesh);
    for (const AlignmentMethod method : kAllMethods) QVERIFY(!fitter.fit(method, {}));
  }

  void onlyMeshesHaveProjectors() {
    const test::EvaluationSite made = test::makeEvaluationSite(test::bentWarp(), 10);
    MethodFitter fitter(made.mesh);
    QVERIFY(fitter.fitProjector(AlignmentMethod::kStretch, made.site.anchors));
    QVERIFY(fitter.fitProjector(AlignmentMethod::kRigid, made.site.anchors));
    QVERIFY(!fitter.fitProjector(AlignmentMethod::kAffine, made.site.anchors));
  }
};

QTEST_APPLESS_MAIN(AlignmentMethodTest)
#include "alignment_method_test.moc"
