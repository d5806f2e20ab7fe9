// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/evaluation/parallel_for.h"

#include <QtTest>

#include <atomic>
#include <stdexcept>
#include <vector>

using namespace cad2slam;

class ParallelForTest : public QObject {
  Q_OBJECT
 private slots:
  void eachIndexOnce() {
    for (const unsigned threads : {0U, 1U, 2U, 7U}) {
      std::vector<std::atomic<int>> calls(1000);
      parallelFor(calls.size(), threads, [&](unsigned, std::size_t index) { ++calls[index]; });
      for (const auto& count : calls) QCOMPARE(count.load(), 1);
    }
  }

  void workersAreNumberedAndNeverTwiceAtOnce() {
    constexpr unsigned kThreads = 4;
    std::vector<std::atomic<int>> busy(kThreads);
    std::atomic<bool> clash{false};
    parallelFor(500, kThreads, [&](unsigned worker, std::size_t) {
      if (worker >= kThreads || ++busy[worker] != 1) clash = true;
      --busy[worker];
    });
    QVERIFY(!clash);
  }

  void nothingToDo() {
    parallelFor(0, 4, [](unsigned, std::size_t) { QFAIL("called"); });
    QCOMPARE(workerCount(0, 4), 1U);
    QCOMPARE(workerCount(2, 4), 2U);
    QCOMPARE(workerCount(100, 4), 4U);
  }

  void exceptionsReachTheCaller() {
    QVERIFY_EXCEPTION_THROWN(parallelFor(100, 3,
                                         [](unsigned, std::size_t index) {
                                           if (index == 50) throw std::runtime_error("fifty");
                                         }),
                             std::runtime_error);
  }
};

QTEST_APPLESS_MAIN(ParallelForTest)
#include "parallel_for_test.moc"
