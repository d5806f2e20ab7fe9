// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include <QtTest>

#include <limits>

#include "cad2slam/anchors/anchor_checks.h"

namespace cad2slam {
namespace {

Anchor anchorAt(AnchorId id, double x, double y, double slam_x, double slam_y) {
  Anchor anchor;
  anchor.id = id;
  anchor.in_blueprint = {x, y};
  anchor.in_slam = {slam_x, slam_y};
  return anchor;
}

AnchorFrames frames() {
  return {*MapFrame::create(0.1, 100, 50, {}), *MapFrame::create(0.05, 400, 400, {{-5.0, -5.0}, 0.0})};
}

}  // namespace

class AnchorChecksTest : public QObject {
  Q_OBJECT
 private slots:
  void goodAnchorsPass();
  void namesTheCulprit();
  void contradictionNamesBoth();
  void disabledAnchorsMayBeWrong();
};

void AnchorChecksTest::goodAnchorsPass() {
  const AnchorList anchors{anchorAt(1, 1, 1, 2, 2), anchorAt(2, 9, 4, 10, 5), anchorAt(3, -0.5, 4, 10.1, 5)};
  QVERIFY(checkAnchors(anchors, frames()).has_value());
  QVERIFY(checkAnchors({}, frames()).has_value());
}

void AnchorChecksTest::namesTheCulprit() {
  AnchorList anchors{anchorAt(1, 1, 1, 2, 2), anchorAt(12, 9, 4, 10, 5)};
  anchors[1].in_slam.x() = std::numeric_limits<double>::infinity();
  QCOMPARE(checkAnchors(anchors, frames()).error().where, std::string("anchor 12"));
  anchors[1] = anchorAt(1, 9, 4, 10, 5);
  QCOMPARE(checkAnchors(anchors, frames()).error().code, ErrorCode::kMalformed);
  anchors[1] = anchorAt(7, 300, 4, 10, 5);
  QCOMPARE(checkAnchors(anchors, frames()).error().code, ErrorCode::kOutOfDomain);
  QCOMPARE(checkAnchors(anchors, frames()).error().where, std::string("anchor 7"));
  QVERIFY2(checkAnchors(anchors, {}).has_value(), "without a frame nothing is outside");
}

void AnchorChecksTest::contradictionNamesBoth() {
  const AnchorList anchors{anchorAt(3, 1, 1, 2, 2), anchorAt(5, 4, 4, 6, 6), anchorAt(9, 1, 1, 2, 3.8)};
  const Result<void> checked = checkAnchors(anchors, frames());
  QVERIFY(!checked.has_value());
  QCOMPARE(checked.error().code, ErrorCode::kDegenerate);
  QVERIFY(checked.error().message.find("3 and 9") != std::string::npos);
  QVERIFY(checked.error().message.find("1.80 m") != std::string::npos);
  const AnchorList agreeing{anchorAt(3, 1, 1, 2, 2), anchorAt(9, 1, 1, 2, 2.1)};
  QVERIFY(checkAnchors(agreeing, frames()).has_value());
}

void AnchorChecksTest::disabledAnchorsMayBeWrong() {
  AnchorList anchors{anchorAt(3, 1, 1, 2, 2), anchorAt(9, 1, 1, 2, 3.8), anchorAt(10, 900, 1, 2, 3.8)};
  anchors[1].enabled = anchors[2].enabled = false;
  QVERIFY(checkAnchors(anchors, frames()).has_value());
}

}  // namespace cad2slam

QTEST_GUILESS_MAIN(cad2slam::AnchorChecksTest)
#include "anchor_checks_test.moc"
