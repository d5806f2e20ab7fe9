// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/main_window/busy_delay.h"

#include <QSignalSpy>
#include <QTest>

using namespace cad2slam;

class BusyDelayTest : public QObject {
  Q_OBJECT

 private slots:
  void whatIsBriefIsNotShown() {
    BusyDelay busy;
    const QSignalSpy spy(&busy, &BusyDelay::becameLong);
    busy.setBusy(true);
    QVERIFY(busy.isBrief());
    QVERIFY(!busy.isShown());
    busy.setBusy(false);
    QVERIFY(!busy.isBrief());
    QTest::qWait(2 * BusyDelay::kShownAfter_ms);
    QVERIFY(!busy.isShown());
    QCOMPARE(spy.count(), 0);
  }

  void whatIsLongIsShownOnceAndUntilItsEnd() {
    BusyDelay busy;
    QSignalSpy spy(&busy, &BusyDelay::becameLong);
    busy.setBusy(true);
    QVERIFY(spy.wait());
    QVERIFY(busy.isShown());
    QVERIFY(!busy.isBrief());
    busy.setBusy(true);
    QVERIFY(busy.isShown());
    busy.setBusy(false);
    QVERIFY(!busy.isShown());
    QCOMPARE(spy.count(), 1);
  }

  void manyShortPiecesAreALongOne() {
    BusyDelay busy;
    const QSignalSpy spy(&busy, &BusyDelay::becameLong);
    QTimer pieces;  // as in a drag: a new solve is asked for before the last one has ended
    pieces.start(5);
    connect(&pieces, &QTimer::timeout, &busy, [&busy] { busy.setBusy(true); });
    QTRY_COMPARE(spy.count(), 1);
    QVERIFY(busy.isShown());
  }
};

QTEST_MAIN(BusyDelayTest)
#include "busy_delay_test.moc"
