// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/main_window/view_pair.h"

#include "ui/support/office_window.h"

#include <QImage>
#include <QMouseEvent>

using namespace cad2slam;
using test::OfficeWindow;

class ViewPairTest : public QObject {
  Q_OBJECT

 private slots:
  void theMirroredCursorFollowsANewResult() {
    const test::Sandbox sandbox;
    OfficeWindow office;
    office.addExact(3);
    QVERIFY(office.waitUntilSolved());
    for (const ActionId id : {ActionId::kMarkers, ActionId::kResiduals})
      office.window.actionTable()[id]->setChecked(false);
    MapView& left = office.window.view(Side::kBlueprint);
    MapView& right = office.window.view(Side::kSlam);
    const QPointF at = left.widgetFromMetres(toQPointF(office.pairs[0].in_blueprint));
    const QPointF pointed = left.metresFromWidget(at);
    QMouseEvent move(QEvent::MouseMove, at, left.mapToGlobal(at), Qt::NoButton, Qt::NoButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&left, &move);
    const QPointF before = office.session().carry(Side::kBlueprint, pointed)->point_m;
    edit::moveAnchor(office.document(), office.document().anchors()[0].id, Side::kSlam,
                     office.pairs[0].in_slam + Eigen::Vector2d(3.0, 2.0), office.document().newGesture());
    QVERIFY(office.waitUntilSolved());
    const QPointF expected = right.widgetFromMetres(office.session().carry(Side::kBlueprint, pointed)->point_m);
    QVERIFY(QLineF(expected, right.widgetFromMetres(before)).length() > 4.0);
    // It is what goes when the mouse leaves.
    const QImage with = right.grab().toImage();
    QEvent leave(QEvent::Leave);
    QCoreApplication::sendEvent(&left, &leave);
    const QImage without = right.grab().toImage();
    QRect changed;
    for (int y = 0; y < with.height(); ++y)
      for (int x = 0; x < with.width(); ++x)
        if (with.pixel(x, y) != without.pixel(x, y)) changed |= QRect(x, y, 1, 1);
    const QPointF middle = QRectF(changed).center() / with.devicePixelRatio();
    QVERIFY2(QLineF(middle, expected).length() <= 1.5, qPrintable(QString::number(QLineF(middle, expected).length())));
  }
};

QTEST_MAIN(ViewPairTest)
#include "view_pair_test.moc"
