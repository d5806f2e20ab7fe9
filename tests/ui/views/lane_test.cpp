// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/views/lane.h"

#include <QTest>
#include <QThread>

#include <algorithm>
#include <atomic>
#include <memory>
#include <set>
#include <stdexcept>
#include <vector>

using namespace cad2slam;

class LaneTest : public QObject {
  Q_OBJECT

 private slots:
  void oneAtATimeKeepsTheOrder_data() {
    QTest::addColumn<bool>("own");
    QTest::newRow("shared threads") << false;
    QTest::newRow("a thread of its own") << true;
  }
  void oneAtATimeKeepsTheOrder() {
    QFETCH(const bool, own);
    std::vector<int> order;  // by one thread after the other: without a lock
    {
      Lane lane(1, own ? Lane::Threads::kOwn : Lane::Threads::kShared);
      for (int i = 0; i < 1000; ++i) lane.start([&order, i] { order.push_back(i); });
    }
    QCOMPARE(order.size(), std::size_t(1000));
    QVERIFY(std::is_sorted(order.begin(), order.end()));
  }

  void noMoreThanSaidRunAtOnce() {
    std::atomic<int> running = 0;
    std::atomic<int> most = 0;
    std::atomic<int> done = 0;
    Lane lane(2);
    for (int i = 0; i < 40; ++i)
      lane.start([&] {
        const int now = ++running;
        int seen = most;
        while (seen < now && !most.compare_exchange_weak(seen, now)) {
        }
        QThread::msleep(1);
        --running;
        ++done;
      });
    lane.waitForDone();
    QCOMPARE(done.load(), 40);
    QVERIFY(most <= 2);
  }

  void aLaneDoesNotWaitForAnother() {
    std::atomic<bool> go_on = false;
    std::vector<std::unique_ptr<Lane>> waiting;
    for (int i = 0; i < 20; ++i) {
      waiting.push_back(std::make_unique<Lane>());
      waiting.back()->start([&go_on] {
        while (!go_on) QThread::msleep(1);
      });
    }
    Lane lane;
    const QFuture<int> answer = lane.run<int>([](QPromise<int>& promise) { promise.addResult(42); });
    QTRY_VERIFY(answer.isFinished());
    QCOMPARE(answer.result(), 42);
    go_on = true;
  }

  void whatIsCancelledBeforeItsTurnIsNotBegun() {
    std::atomic<bool> go_on = false;
    bool begun = false;
    Lane lane;
    lane.start([&go_on] {
      while (!go_on) QThread::msleep(1);
    });
    QFuture<int> answer = lane.run<int>([&begun](QPromise<int>& promise) {
      begun = true;
      promise.addResult(1);
    });
    answer.cancel();
    go_on = true;
    lane.waitForDone();
    QVERIFY(!begun);
    QVERIFY(answer.isFinished());
    QCOMPARE(answer.resultCount(), 0);
  }

  void whatWorkThrowsIsThrownByItsResult() {
    Lane lane;
    QFuture<int> answer = lane.run<int>([](QPromise<int>&) { throw std::runtime_error("no"); });
    QVERIFY_EXCEPTION_THROWN(answer.waitForFinished(), std::runtime_error);
    // The lane goes on.
    QCOMPARE(lane.run<int>([](QPromise<int>& promise) { promise.addResult(7); }).result(), 7);
  }

  void threadsAreUsedAgain() {
    std::set<QThread*> used;
    Lane lane(1, Lane::Threads::kOwn);
    for (int i = 0; i < 20; ++i) {
      lane.start([&used] { used.insert(QThread::currentThread()); });
      lane.waitForDone();
    }
    QCOMPARE(used.size(), std::size_t(1));
    QVERIFY(!used.contains(QThread::currentThread()));
  }
};

QTEST_GUILESS_MAIN(LaneTest)
#include "lane_test.moc"
