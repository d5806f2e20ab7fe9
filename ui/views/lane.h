// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QFuture>
#include <QPromise>

#include <exception>
#include <functional>
#include <memory>
#include <utility>

class QThreadPool;

namespace cad2slam {

/// Runs work in the order in which it is given, so many pieces at a time, on threads that give way to the window.
///
/// All lanes share their threads but those that need much memory again and again: what a thread has freed is kept for
/// it, and would be kept once for each thread. The threads give way to the window and stay until the program ends: to
/// start one costs its caller half a millisecond (its memory is touched for the first time), and the caller is the
/// window, at the moment when it has most to do. Not Qt's own pool, which fills large areas while the window waits for
/// it.
///
/// All functions may be called from any thread but those of the lane itself.
class Lane {
 public:
  enum class Threads { kShared, kOwn };

  explicit Lane(int at_once = 1, Threads threads = Threads::kShared);
  ~Lane();  ///< waits until everything is done
  Lane(const Lane&) = delete;
  Lane& operator=(const Lane&) = delete;

  /// `task` must not throw.
  void start(std::function<void()> task);

  /// `work(QPromise<Answer>&)`; not begun where the future is cancelled before its turn. What it throws is thrown by
  /// result() of the future.
  template <class Answer, class Work>
  [[nodiscard]] QFuture<Answer> run(Work work) {
    auto promise = std::make_shared<QPromise<Answer>>();
    promise->start();  // now: nobody can wait for a future before that
    start([promise, work = std::move(work)] {
      try {
        if (!promise->isCanceled()) work(*promise);
      } catch (...) {
        promise->setException(std::current_exception());
      }
      promise->finish();
    });
    return promise->future();
  }

  void waitForDone();

  /// Starts shared threads that wait for work, so that the first pieces find them.
  static void prepareSharedThreads(int count);

 private:
  struct State;
  static void work(const std::shared_ptr<State>& state);

  std::shared_ptr<State> state_;
  std::unique_ptr<QThreadPool> own_;
};

}  // namespace cad2slam
