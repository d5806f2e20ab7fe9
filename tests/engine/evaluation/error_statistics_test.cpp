// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/evaluation/error_statistics.h"

#include <QtTest>

#include <cmath>
#include <limits>

using namespace cad2slam;

class ErrorStatisticsTest : public QObject {
  Q_OBJECT
 private slots:
  void knownSample() {
    const ErrorStatistics statistics = summarise({4.0, 1.0, 3.0, 2.0, 5.0});
    QCOMPARE(statistics.count, std::size_t{5});
    QCOMPARE(statistics.mean, 3.0);
    QCOMPARE(statistics.median, 3.0);
    QCOMPARE(statistics.deviation, std::sqrt(2.0));
    QCOMPARE(statistics.p90, 4.6);
    QCOMPARE(statistics.p95, 4.8);
    QCOMPARE(statistics.max, 5.0);
  }

  void oneNumberIsAllOfThem() {
    const ErrorStatistics statistics = summarise({0.25});
    for (const double value : {statistics.mean, statistics.median, statistics.p90, statistics.p95, statistics.max}) {
      QCOMPARE(value, 0.25);
    }
    QCOMPARE(statistics.deviation, 0.0);
  }

  void emptySampleIsNotANumber() {
    const ErrorStatistics statistics = summarise({});
    QCOMPARE(statistics.count, std::size_t{0});
    QVERIFY(std::isnan(statistics.mean) && std::isnan(statistics.median) && std::isnan(statistics.max));
  }

  void failuresAreInfiniteAndDoNotHideTheMedian() {
    const ErrorStatistics statistics =
        summarise({1.0, std::nan(""), 2.0, 3.0, -std::numeric_limits<double>::infinity()});
    QCOMPARE(statistics.median, 3.0);
    QVERIFY(std::isinf(statistics.mean) && std::isinf(statistics.max));
  }
};

QTEST_APPLESS_MAIN(ErrorStatisticsTest)
#include "error_statistics_test.moc"
