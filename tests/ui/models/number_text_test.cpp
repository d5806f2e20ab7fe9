// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/models/number_text.h"

#include <QLocale>
#include <QTest>

#include <cmath>

using namespace cad2slam;

class NumberTextTest : public QObject {
  Q_OBJECT

 private slots:
  void cleanup() { QLocale::setDefault(QLocale::c()); }

  void whatIsWrittenCanBeTypedInEveryLanguage() {
    const QList<QLocale> all =
        QLocale::matchingLocales(QLocale::AnyLanguage, QLocale::AnyScript, QLocale::AnyTerritory);
    QVERIFY(all.size() > 100);
    for (const QLocale& locale : all) {
      QLocale::setDefault(locale);
      for (const double value : {-1234567.125, -1.5, 0.0, 0.25, 1e9}) {
        const QString text = numberText(value, 3);
        const std::optional<double> read = parseNumber(text);
        QVERIFY2(read && *read == value, qPrintable(locale.name() + QStringLiteral(" writes ") + text));
      }
      const QString shortest = shortNumberText(-0.0123);
      QVERIFY2(parseNumber(shortest) == -0.0123, qPrintable(locale.name() + QStringLiteral(" writes ") + shortest));
    }
  }

  void theDecimalSignIsThatOfTheLanguage() {
    QLocale::setDefault(QLocale(QLocale::German));
    QCOMPARE(numberText(-12345.678, 2), QStringLiteral("-12345,68"));
    QCOMPARE(shortNumberText(0.5), QStringLiteral("0,5"));
    QLocale::setDefault(QLocale(QLocale::English));
    QCOMPARE(numberText(-12345.678, 2), QStringLiteral("-12345.68"));
  }

  void twoNumbersAreToldApart() {
    QCOMPARE(pairText(1.25, -3.0, 1), QStringLiteral("1.3, -3.0"));
    QLocale::setDefault(QLocale(QLocale::German));
    QCOMPARE(pairText(1.25, -3.0, 1), QStringLiteral("1,3; -3,0"));
  }

  void aRoundedZeroHasNoSign() {
    QCOMPARE(numberText(-0.0001, 3), QStringLiteral("0.000"));
    QCOMPARE(numberText(-0.0006, 3), QStringLiteral("-0.001"));
  }

  void onlyNumbersAreNumbers() {
    for (const char* text : {"", "m", "1,234.5", "1e400", "nan", "inf", "2e9", "1 2"})
      QVERIFY2(!parseNumber(QLatin1String(text)), text);
    QCOMPARE(parseNumber(QStringLiteral(" 1,5 m ")), std::optional(1.5));
    QCOMPARE(parseNumber(QString(QChar(0x2212)) + QStringLiteral("2.5")), std::optional(-2.5));
  }
};

QTEST_MAIN(NumberTextTest)
#include "number_text_test.moc"
