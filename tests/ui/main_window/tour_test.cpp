// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/main_window/tour.h"

#include "ui/support/office_window.h"

#include <cmath>

using namespace cad2slam;
using test::OfficeWindow;

class TourTest : public QObject {
  Q_OBJECT

 private:
  std::optional<test::Sandbox> sandbox_;

  static void start(OfficeWindow& office) {
    (new Tour(office.window, QStringLiteral(CAD2SLAM_SAMPLE_MAPS "/office")))->start();
    QVERIFY(office.waitUntilReady());
  }

 private slots:
  void init() { sandbox_.emplace(); }

  void whatNobodyTouchedIsNotModified() {
    OfficeWindow office(false);
    start(office);
    QVERIFY(office.hasMessage(QStringLiteral("tour")));
    QVERIFY(!office.document().isModified());
    QCOMPARE(office.document().undoStack().count(), 0);
    edit::addAnchor(office.document(), {1.0, 2.0}, {3.0, 4.0});
    QVERIFY(office.document().isModified());
  }

  void aCornerIsWhereItLooksToBeInTheOtherMap() {
    OfficeWindow office(false);
    start(office);
    const AnchorList known = readAnchors(toPath(OfficeWindow::sample("anchors_2.csv"))).value().anchors;
    // From the middle of the anchors each lies in about the same direction on both sides.
    Eigen::Vector2d middle_in_blueprint = Eigen::Vector2d::Zero();
    Eigen::Vector2d middle_in_slam = Eigen::Vector2d::Zero();
    for (const Anchor& anchor : known) {
      middle_in_blueprint += anchor.in_blueprint / static_cast<double>(known.size());
      middle_in_slam += anchor.in_slam / static_cast<double>(known.size());
    }
    for (const Anchor& anchor : known) {
      const Eigen::Vector2d a = anchor.in_blueprint - middle_in_blueprint;
      const Eigen::Vector2d b = anchor.in_slam - middle_in_slam;
      QVERIFY2(a.dot(b) > 0.0, qPrintable(QString::number(anchor.id)));
    }
    for (std::size_t i = 0; i < 4; ++i) edit::addAnchor(office.document(), known[i].in_blueprint, known[i].in_slam);
    QVERIFY(office.waitUntilSolved());
    QVERIFY(std::abs(wrapAngle(office.session().alignment().result()->solution.global_fit.heading)) < kPi / 6.0);
  }

  void withoutTheSampleItSaysSo() {
    OfficeWindow office(false);
    (new Tour(office.window, std::nullopt))->start();
    QVERIFY(office.hasMessage(QStringLiteral("tour")));
    QVERIFY(!office.document().hasBlueprint());
  }
};

QTEST_MAIN(TourTest)
#include "tour_test.moc"
