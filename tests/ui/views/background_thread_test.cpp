// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/views/background_thread.h"

#include <QThreadPool>
#include <QtTest>

#include <sys/resource.h>

#include <algorithm>
#include <atomic>
#include <thread>

using namespace cad2slam;

namespace {

/// Of the calling thread; 20 is the one that gets least.
int nice() {
  return getpriority(PRIO_PROCESS, 0);
}
template <class Work>
void onThread(Work work) {
  std::thread(work).join();
}

}  // namespace

class BackgroundThreadTest : public QObject {
  Q_OBJECT

 private slots:
  void aWorkerGivesWayWithThoseItStarts() {
    const int own = nice();
    int of_worker = 0;
    int of_its_worker = 0;
    onThread([&] {
      giveWayToWindow();
      of_worker = nice();
      onThread([&] { of_its_worker = nice(); });
    });
    QVERIFY(of_worker > own || own >= 10);
    QCOMPARE(of_its_worker, of_worker);
    QCOMPARE(nice(), own);
  }

  // Whoever starts the program with `nice` has said how much it may take.
  void neitherTakesMoreThanTheProgramWasGiven() {
    const int given = std::max(nice(), 13);
    for (void (*const wish)() : {comeBeforeBackground, giveWayToWindow}) {
      int before = 0;
      int after = 0;
      onThread([&] {
        setpriority(PRIO_PROCESS, 0, given);
        before = nice();
        wish();
        after = nice();
      });
      QCOMPARE(before, given);
      QCOMPARE(after, given);
    }
  }

  void startedThreadsWaitForWorkAndStay() {
    QThreadPool pool;
    pool.setMaxThreadCount(3);
    startLastingThreads(pool, 3);
    QTRY_COMPARE(pool.activeThreadCount(), 0);  // all of them have begun, or the others would still wait
    QCOMPARE(pool.expiryTimeout(), -1);
    std::atomic<int> done = 0;
    for (int i = 0; i < 10; ++i) pool.start([&done] { ++done; });
    pool.waitForDone();
    QCOMPARE(done.load(), 10);
  }
};

QTEST_GUILESS_MAIN(BackgroundThreadTest)
#include "background_thread_test.moc"
