// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/models/limits_text.h"

#include "ui/document/judgement.h"

#include <QTest>

using namespace cad2slam;

class LimitsTextTest : public QObject {
  Q_OBJECT

 private slots:
  void everyNumberOfTheRuleIsTold() {
    QLocale::setDefault(QLocale::c());
    const QString text = limitsText({.ok_cells = 1.5, .ok_m = 0.12, .look_cells = 7.0, .look_m = 1.25});
    for (const char* number : {"1.5 pixels", "12.0 cm", "7 pixels", "1.25 m"})
      QVERIFY2(text.contains(QLatin1String(number)), qPrintable(text));
    QVERIFY(text.contains(QString::number(kLeaveOneOutFrom)));
    for (const QString& number :
         {QString::number(kAgainstMedian), QString::number(kSpreadFrom), QString::number(kSpreads)})
      QVERIFY2(badRuleText().contains(number), qPrintable(badRuleText()));
  }

  void aLineFitsAToolTip() {
    for (const QString& line : (limitsText({}) + QLatin1Char('\n') + badRuleText()).split(QLatin1Char('\n')))
      QVERIFY2(line.size() <= 100, qPrintable(line));
  }
};

QTEST_APPLESS_MAIN(LimitsTextTest)
#include "limits_text_test.moc"
