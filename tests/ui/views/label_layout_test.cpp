// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/views/label_layout.h"

#include <QTest>

#include <random>

namespace cad2slam {
namespace {

constexpr double kCore = 7.0;
constexpr double kReach = 11.0;
const QSizeF kText(22.0, 14.0);

QRectF coreOf(const QPointF& at) {
  return QRectF(at - QPointF(kCore, kCore), QSizeF(2.0 * kCore, 2.0 * kCore));
}

class LabelLayoutTest : public QObject {
  Q_OBJECT

 private slots:
  void aMarkerAloneHasItsTextToTheUpperRight() {
    for (double x = 0.0; x < 6.0; x += 0.37) {
      LabelLayout layout(QSizeF(400, 300));
      const QPointF at(100.0 + x, 100.0 + 0.71 * x);
      layout.occupy(coreOf(at));
      const auto area = layout.place(at, kReach, kText);
      QVERIFY(area);
      QCOMPARE(area->left(), at.x() + kReach);
      QVERIFY(area->center().y() < at.y());
    }
  }

  void nothingCoversAnything_data() {
    QTest::addColumn<int>("count");
    for (const int count : {10, 120, 1000}) QTest::addRow("%d", count) << count;
  }
  void nothingCoversAnything() {
    QFETCH(int, count);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> x(-60.0, 860.0);
    std::uniform_real_distribution<double> y(-30.0, 630.0);
    std::vector<QPointF> markers;
    for (int i = 0; i < count; ++i) markers.emplace_back(x(random), y(random));
    LabelLayout layout(QSizeF(800, 600));
    for (const QPointF& at : markers) layout.occupy(coreOf(at));
    std::vector<QRectF> placed;
    for (const QPointF& at : markers) {
      const auto area = layout.place(at, kReach, kText);
      if (!area) continue;
      for (const QPointF& other : markers) QVERIFY(!area->intersects(coreOf(other)));
      for (const QRectF& other : placed) QVERIFY(!area->intersects(other));
      placed.push_back(*area);
    }
    // Where there is plenty of room nearly all are shown; in a crowd some are.
    QVERIFY(placed.size() >= std::size_t(count == 10 ? 9 : count == 120 ? 90 : 50));
  }

  void whatMustBeShownIsShown() {
    LabelLayout layout(QSizeF(400, 300));
    layout.occupy(QRectF(0, 0, 400, 300));
    QVERIFY(!layout.place(QPointF(200, 150), kReach, kText));
    QCOMPARE(layout.placeAnyway(QPointF(200, 150), kReach, kText).size(), kText);
  }

  void textsAreInsideTheViewWhereTheyCanBe() {
    const QRectF view(0, 0, 400, 300);
    for (const QPointF& at :
         {QPointF(395, 150), QPointF(5, 150), QPointF(200, 3), QPointF(200, 297), QPointF(398, 2)}) {
      LabelLayout layout(view.size());
      layout.occupy(coreOf(at));
      const auto area = layout.place(at, kReach, kText);
      QVERIFY(area);
      QVERIFY(view.contains(*area));
      layout.occupy(view);
      QVERIFY(view.contains(layout.placeAnyway(at, kReach, kText)));
    }
    LabelLayout layout(view.size());
    QVERIFY(layout.place(QPointF(-30, 150), kReach, kText));  // a part of it may be seen
  }

  void placesFarOutsideDoNoHarm() {
    LabelLayout layout(QSizeF(400, 300));
    for (const double far : {-1e9, 1e9, 1e300}) {
      layout.occupy(QRectF(far, far, 10.0, 10.0));
      static_cast<void>(layout.place(QPointF(far, -far), kReach, kText));
    }
    QVERIFY(layout.place(QPointF(200, 150), kReach, kText));
  }
};

}  // namespace
}  // namespace cad2slam

QTEST_MAIN(cad2slam::LabelLayoutTest)
#include "label_layout_test.moc"
