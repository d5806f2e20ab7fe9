// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QFutureWatcher>

#include <functional>
#include <optional>
#include <utility>

#include "ui/views/lane.h"

namespace cad2slam {

/// Runs a pure function in the background, one call at a time; of the requests that come while it runs only the
/// newest survives. Every finished call is delivered, so a stream of requests never starves. GUI thread only.
template <class Request, class Answer>
class LatestJob {
 public:
  using Work = std::function<Answer(const Request&)>;
  using Deliver = std::function<void(const Answer&)>;

  LatestJob(Work work, Deliver deliver, Lane::Threads threads = Lane::Threads::kShared)
      : work_(std::move(work)), deliver_(std::move(deliver)), lane_(1, threads) {
    QObject::connect(&watcher_, &QFutureWatcherBase::finished, &watcher_, [this] { onFinished(); });
  }
  ~LatestJob() {
    watcher_.disconnect();
    waiting_.reset();
    watcher_.waitForFinished();
  }
  LatestJob(const LatestJob&) = delete;
  LatestJob& operator=(const LatestJob&) = delete;

  void request(Request request) {
    if (running_) {
      waiting_ = std::move(request);
    } else {
      start(std::move(request));
    }
  }
  /// Forgets what is waiting and drops the answer of what runs.
  void cancel() {
    waiting_.reset();
    dropped_ = running_;
  }
  [[nodiscard]] bool isBusy() const { return running_ && !dropped_; }

 private:
  void start(Request request) {
    running_ = true;
    dropped_ = false;
    watcher_.setFuture(lane_.run<Answer>(
        [work = work_, request = std::move(request)](QPromise<Answer>& promise) { promise.addResult(work(request)); }));
  }
  void onFinished() {
    const QFuture<Answer> future = watcher_.future();
    const bool drop = std::exchange(dropped_, false);
    running_ = false;
    if (waiting_) start(*std::exchange(waiting_, std::nullopt));
    if (!drop && future.resultCount() == 1) deliver_(future.result());
  }

  Work work_;
  Deliver deliver_;
  Lane lane_;
  QFutureWatcher<Answer> watcher_;
  std::optional<Request> waiting_;
  bool running_ = false;
  bool dropped_ = false;
};

}  // namespace cad2slam
