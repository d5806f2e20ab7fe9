// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/io/text.h"

#include <QtTest>

#include <cstring>
#include <limits>
#include <random>

using namespace cad2slam;

class TextTest : public QObject {
  Q_OBJECT

 private slots:
  void numbersReadBackExactly() {
    std::mt19937_64 random(11);
    for (int k = 0; k < 100000; ++k) {
      const std::uint64_t bits = random();
      double number = 0.0;
      std::memcpy(&number, &bits, sizeof number);
      if (!std::isfinite(number)) continue;
      const std::optional<double> read = parseNumber(formatNumber(number));
      QVERIFY(read && std::memcmp(&*read, &number, sizeof number) == 0);
    }
    QCOMPARE(formatNumber(0.1), std::string("0.1"));
    QCOMPARE(formatNumber(-0.0), std::string("-0"));
  }

  void onlyWholeFiniteNumbersAreNumbers() {
    for (const char* text : {"1", "-1.5", "+2", ".5", "5.", "1e-7", "-0"}) QVERIFY2(parseNumber(text), text);
    for (const char* text :
         {"", "+", "-", "+-1", "1 ", " 1", "1,5", "0x10", "nan", "inf", "-inf", "1e999", "1e", "1.2.3"}) {
      QVERIFY2(!parseNumber(text), text);
    }
    QCOMPARE(*parseInteger<int>("-12"), -12);
    for (const char* text : {"", "1.0", "99999999999", "0x1", "+-1", "1 "}) QVERIFY2(!parseInteger<int>(text), text);
    QVERIFY(!parseInteger<std::uint8_t>("-1"));
  }

  void unicodeIsToldFromOtherBytes() {
    for (const char* text : {"", "abc", "T\xc3\xbcr", "\xe2\x82\xac", "\xf0\x9f\x9a\xaa", "\xed\x9f\xbf"}) {
      QVERIFY(isUtf8(text));
    }
    for (const char* text :
         {"T\xfcr", "\xc3", "\xc0\x80", "\xe0\x80\x80", "\xed\xa0\x80", "\xf4\x90\x80\x80", "\xff"}) {
      QVERIFY(!isUtf8(text));
    }
  }

  void excerptsAreShortAndPrintable() {
    QCOMPARE(excerpt("door"), std::string("'door'"));
    QCOMPARE(excerpt("a\x1b[31m\nb\xff"), std::string("'a?[31m?b?'"));
    const std::string long_excerpt = excerpt(std::string(100000, 'x'));
    QVERIFY(long_excerpt.size() < 50);
    QVERIFY(isUtf8(excerpt(std::string(39, 'x') + "\xf0\x9f\x9a\xaa")));
  }
};

QTEST_APPLESS_MAIN(TextTest)
#include "text_test.moc"
