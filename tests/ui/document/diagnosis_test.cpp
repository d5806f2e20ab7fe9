// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/document/diagnosis.h"

#include "cad2slam/geometry/similarity2.h"

#include <QTest>

#include <algorithm>
#include <random>

using namespace cad2slam;
using Kind = Finding::Kind;

namespace {

/// Anchors over a 40 m x 25 m building, seen by a robot through a similarity and a few centimetres of noise.
AnchorList building(std::size_t count, const Similarity2& slam_from_blueprint, double noise_m = 0.03) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> along(0.0, 40.0);
  std::uniform_real_distribution<double> across(0.0, 25.0);
  std::normal_distribution<double> noise(0.0, noise_m);
  AnchorList anchors;
  for (std::size_t i = 0; i < count; ++i) {
    Anchor anchor;
    anchor.id = static_cast<AnchorId>(i) + 1;
    anchor.in_blueprint = {along(random), across(random)};
    anchor.in_slam = slam_from_blueprint * anchor.in_blueprint + Eigen::Vector2d(noise(random), noise(random));
    anchors.push_back(anchor);
  }
  return anchors;
}

DiagnosisInput inputOf(AnchorList anchors) {
  DiagnosisInput input;
  input.anchors = std::move(anchors);
  input.blueprint_diagonal_m = 47.0;
  return input;
}

const Finding* find(const std::vector<Finding>& findings, Kind kind) {
  const auto found =
      std::find_if(findings.begin(), findings.end(), [&](const Finding& each) { return each.kind == kind; });
  return found == findings.end() ? nullptr : &*found;
}

const Similarity2 kTurned{1.0, 168.0 * kPi / 180.0, {12.0, -7.0}};

}  // namespace

class DiagnosisTest : public QObject {
  Q_OBJECT

 private slots:
  void nothingIsSaidOfGoodAnchors_data() {
    QTest::addColumn<int>("count");
    for (const int count : {0, 1, 3, 4, 12, 100}) QTest::addRow("%d", count) << count;
  }
  void nothingIsSaidOfGoodAnchors() {
    QFETCH(int, count);
    const auto findings = diagnose(inputOf(building(std::size_t(count), kTurned)));
    QVERIFY2(findings.empty(), findings.empty() ? "" : qPrintable(QString::number(int(findings[0].kind))));
  }

  void anchorsWithoutGroundAreNamed() {
    DiagnosisInput input = inputOf(building(8, kTurned));
    input.anchors[5].enabled = false;
    input.ground_in_blueprint.assign(8, Ground::kKnown);
    input.ground_in_slam.assign(8, Ground::kKnown);
    QVERIFY(diagnose(input).empty());
    input.ground_in_slam[2] = input.ground_in_slam[5] = input.ground_in_slam[7] = Ground::kUnknown;
    input.ground_in_blueprint[4] = Ground::kOutsideImage;
    const auto findings = diagnose(input);
    QCOMPARE(findings.size(), std::size_t(2));
    QVERIFY(findings[0].kind == Kind::kOutsideImage && findings[0].side == Side::kBlueprint);
    QVERIFY(findings[0].anchors == std::vector<AnchorId>{5});
    QVERIFY(findings[1].kind == Kind::kUnknownGround && findings[1].side == Side::kSlam);
    QVERIFY((findings[1].anchors == std::vector<AnchorId>{3, 8}));  // 6 is disabled
  }

  void scenario12_scale_data() {
    QTest::addColumn<double>("scale");
    for (const double scale : {0.5, 0.97, 1.03, 1.37, 2.0}) QTest::addRow("%g", scale) << scale;
  }
  void scenario12_scale() {
    QFETCH(double, scale);
    Similarity2 wrong = kTurned;
    wrong.scale = scale;
    const auto findings = diagnose(inputOf(building(12, wrong)));
    QVERIFY(find(findings, Kind::kScale));
    QVERIFY(std::abs(find(findings, Kind::kScale)->value / scale - 1.0) < 0.005);
    DiagnosisInput unknown = inputOf(building(12, wrong));
    unknown.scale.rule = ScaleRule::kLeastSquares;  // the installer knows that it is not to scale
    QVERIFY(!find(diagnose(unknown), Kind::kScale));
  }

  void aMapThatDisagreesWithTheBlueprintAndAnotherMapIsTheOneThatIsWrong() {
    Similarity2 small = kTurned;
    small.scale = 0.966;
    DiagnosisInput input = inputOf(building(12, small));
    const Similarity2 straight{1.0, 0.1, {2.0, 3.0}};
    input.others = {{"empty", {}}, {"as wrong", building(6, small)}};
    QVERIFY(find(diagnose(input), Kind::kScale)->agrees.empty());
    input.others.emplace_back("Robot 1", building(6, straight));
    QCOMPARE(find(diagnose(input), Kind::kScale)->agrees, std::string("Robot 1"));
    input.anchors.resize(2);
    QCOMPARE(find(diagnose(input), Kind::kLengths)->agrees, std::string("Robot 1"));
    for (Anchor& anchor : input.others.back().second) anchor.enabled = false;
    QVERIFY(find(diagnose(input), Kind::kLengths)->agrees.empty());
  }

  void scenario12_mirrored() {
    AnchorList anchors = building(6, kTurned);
    for (Anchor& anchor : anchors) anchor.in_blueprint.x() = 40.0 - anchor.in_blueprint.x();
    const auto findings = diagnose(inputOf(anchors));
    QVERIFY(find(findings, Kind::kMirrored));
    QVERIFY(!find(findings, Kind::kScale));  // one thing at a time
    QVERIFY(find(findings, Kind::kMirrored)->other < 0.1);
  }

  void scenario10_swapped() {
    AnchorList anchors = building(12, kTurned);
    std::swap(anchors[3].in_slam, anchors[8].in_slam);
    const auto findings = diagnose(inputOf(anchors));
    QVERIFY(find(findings, Kind::kSwapped));
    std::vector<AnchorId> named = find(findings, Kind::kSwapped)->anchors;
    std::sort(named.begin(), named.end());
    QCOMPARE(named, (std::vector<AnchorId>{4, 9}));
    QVERIFY(!find(findings, Kind::kMirrored));
  }

  void oneBadAnchorIsNoSwapAndNoMirror() {
    AnchorList anchors = building(12, kTurned);
    anchors[5].in_slam += Eigen::Vector2d(6.0, -4.0);
    const auto findings = diagnose(inputOf(anchors));
    QVERIFY(!find(findings, Kind::kSwapped));
    QVERIFY(!find(findings, Kind::kMirrored));
    QVERIFY(!find(findings, Kind::kScale));
  }

  void scenario11_duplicates() {
    AnchorList anchors = building(6, kTurned);
    anchors[5].in_blueprint = anchors[2].in_blueprint;
    anchors[5].in_slam = anchors[2].in_slam + Eigen::Vector2d(0.0, 1.8);
    const Finding finding = *find(diagnose(inputOf(anchors)), Kind::kDuplicate);
    QCOMPARE(finding.anchors, (std::vector<AnchorId>{3, 6}));
    QVERIFY(std::abs(finding.value - 1.8) < 1e-9);
    anchors[5].enabled = false;
    QVERIFY(!find(diagnose(inputOf(anchors)), Kind::kDuplicate));
  }

  void scenario11_line() {
    AnchorList anchors = building(5, kTurned);
    for (Anchor& anchor : anchors) {
      anchor.in_blueprint.y() = 3.0;
      anchor.in_slam = kTurned * anchor.in_blueprint;
    }
    const std::vector<Eigen::Vector2d> nodes{{500.0, 3.0}, {2.0, 9.0}, {4.0, 0.0}};
    DiagnosisInput input = inputOf(anchors);
    input.nodes = &nodes;
    QCOMPARE(find(diagnose(input), Kind::kCollinear)->place.value(), nodes[1]);
  }

  void twoAnchors() {
    AnchorList anchors = building(2, kTurned);
    anchors[0].in_blueprint = {0, 0};
    anchors[1].in_blueprint = {20.0, 0};
    anchors[0].in_slam = {0, 0};
    anchors[1].in_slam = {0, 20.62};
    const Finding lengths = *find(diagnose(inputOf(anchors)), Kind::kLengths);
    QCOMPARE(lengths.value, 20.0);
    QCOMPARE(lengths.other, 20.62);
    anchors[1].in_blueprint = anchors[0].in_blueprint;
    DiagnosisInput without_size = inputOf(anchors);
    without_size.blueprint_diagonal_m = 0.0;
    QVERIFY2(!find(diagnose(without_size), Kind::kLengths), "no length to compare with");
    anchors[1].in_blueprint = {1.0, 0};
    const std::vector<Eigen::Vector2d> nodes{{3.0, 1.0}, {12.0, -4.0}, {0.5, 0.0}};
    DiagnosisInput input = inputOf(anchors);
    input.nodes = &nodes;
    const std::vector<Finding> found = diagnose(input);
    QCOMPARE(find(found, Kind::kClose)->place.value(), nodes[1]);
    QVERIFY2(!find(found, Kind::kLengths), "two clicks side by side say nothing about the scale");
  }

  void anOutlierIsNamedByItsLeaveOneOutError() {
    const AnchorList anchors = building(8, kTurned);
    Solution solution;
    for (const Anchor& anchor : anchors) {
      AnchorFit fit;
      fit.id = anchor.id;
      fit.leave_one_out_m = anchor.id == 6 ? 2.0 : 0.05;
      solution.anchors.push_back(fit);
    }
    DiagnosisInput input = inputOf(anchors);
    input.solution = &solution;
    QCOMPARE(find(diagnose(input), Kind::kOutlier)->anchors, std::vector<AnchorId>{6});
  }

  void anchorsThatDoNotPredictEachOtherAreSaidToBeSo() {
    const AnchorList anchors = building(4, kTurned);
    Solution solution;
    for (const Anchor& anchor : anchors) {
      AnchorFit fit;
      fit.id = anchor.id;
      fit.residual_m = 0.005;  // the mesh bends to whatever it is given
      fit.leave_one_out_m = 1.5 + 0.1 * static_cast<double>(anchor.id);
      solution.anchors.push_back(fit);
    }
    const std::vector<Eigen::Vector2d> nodes{anchors[0].in_blueprint, {500.0, 3.0}};
    DiagnosisInput input = inputOf(anchors);
    input.solution = &solution;
    input.nodes = &nodes;
    const auto findings = diagnose(input);
    QVERIFY(find(findings, Kind::kUnpredicted));
    QCOMPARE(find(findings, Kind::kUnpredicted)->value, 1.75);
    QCOMPARE(find(findings, Kind::kUnpredicted)->place.value(), nodes[1]);
    for (AnchorFit& fit : solution.anchors) fit.leave_one_out_m = 0.2;
    QVERIFY(!find(diagnose(input), Kind::kUnpredicted));
  }

  void anchorsThatAllHaveOneOppositeFitAfterHalfATurn() {
    AnchorList corners = building(4, kTurned);
    const Eigen::Vector2d places[] = {{0.0, 0.0}, {40.0, 0.0}, {40.0, 25.0}, {0.0, 25.0}};
    for (std::size_t i = 0; i < 4; ++i) {
      corners[i].in_blueprint = places[i];
      corners[i].in_slam = kTurned * places[i];
    }
    QVERIFY(find(diagnose(inputOf(corners)), Kind::kHalfTurn));
    for (std::size_t i = 0; i < 4; ++i) corners[i].in_slam = kTurned * places[(i + 2) % 4];
    QVERIFY2(find(diagnose(inputOf(corners)), Kind::kHalfTurn), "nor the other way round");
    Anchor inside = corners[0];
    inside.id = 5;
    inside.in_blueprint = {9.0, 4.0};
    inside.in_slam = kTurned * Eigen::Vector2d(31.0, 21.0);
    corners.push_back(inside);
    QVERIFY2(!find(diagnose(inputOf(corners)), Kind::kHalfTurn), "that one tells");
  }

  void aPlainSimilarityIsSaidToBeEnough() {
    const AnchorList anchors = building(10, kTurned);
    Solution solution;
    for (const Anchor& anchor : anchors) {
      AnchorFit fit;
      fit.id = anchor.id;
      fit.leave_one_out_m = 0.2;
      solution.anchors.push_back(fit);
    }
    DiagnosisInput input = inputOf(anchors);
    input.solution = &solution;
    QVERIFY(find(diagnose(input), Kind::kSimilarityEnough));
  }

  void notANumberAndHugeNumbersAreSurvived() {
    AnchorList anchors = building(6, kTurned);
    anchors[1].in_slam.x() = std::nan("");
    anchors[2].in_blueprint.x() = 1e300;
    (void)diagnose(inputOf(anchors));
    for (Anchor& anchor : anchors) anchor.in_blueprint = {1.0, 1.0};
    (void)diagnose(inputOf(anchors));
  }
};

QTEST_GUILESS_MAIN(DiagnosisTest)
#include "diagnosis_test.moc"
