// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/services/solve_service.h"

#include "ui/convert.h"
#include "ui/services/guarded.h"
#include "ui/services/solve_worker.h"

#include <utility>

namespace cad2slam {

SolveService::SolveService(QObject* parent) : QObject(parent), worker_(std::make_shared<SolveWorker>()) {
  connect(&watcher_, &QFutureWatcher<Outcome>::finished, this, &SolveService::onFinished);
  connect(&watcher_, &QFutureWatcher<Outcome>::progressValueChanged, this, [this](int iteration) {
    if (running_ && !running_->aside) emit progressed(iteration);
  });
}

SolveService::~SolveService() {
  watcher_.disconnect(this);
  watcher_.cancel();
  watcher_.waitForFinished();
  lane_.waitForDone();
}

void SolveService::request(SolveRequest request) {
  std::erase_if(aside_, [&](const SolveRequest& waiting) { return waiting.map == request.map; });
  waiting_ = std::move(request);
  if (!running_) return startNext();
  if (running_->aside) {
    stopAside();
  } else if (running_->request.quality == Quality::kFull) {
    watcher_.cancel();
  }
}

void SolveService::cancel() {
  waiting_.reset();
  if (running_ && !running_->aside) watcher_.cancel();
}

void SolveService::requestAside(SolveRequest request) {
  if (running_ && running_->aside && running_->request.map == request.map) watcher_.cancel();
  std::erase_if(aside_, [&](const SolveRequest& waiting) { return waiting.map == request.map; });
  aside_.push_back(std::move(request));
  if (!running_) startNext();
}

void SolveService::cancelAside() {
  aside_.clear();
  if (running_ && running_->aside) watcher_.cancel();
}

void SolveService::stopAside() {
  if (!running_ || !running_->aside || watcher_.isCanceled()) return;  // once cancelled, it was replaced or dropped
  watcher_.cancel();
  aside_.push_front(running_->request);
}

void SolveService::startNext() {
  if (waiting_ && std::exchange(waiting_->preview_first, false)) {
    SolveRequest preview = *waiting_;
    preview.quality = Quality::kPreview;
    start(std::move(preview), false);
  } else if (waiting_) {
    start(*std::exchange(waiting_, std::nullopt), false);
  } else if (!aside_.empty()) {
    SolveRequest next = std::move(aside_.front());
    aside_.pop_front();
    start(std::move(next), true);
  }
}

void SolveService::start(SolveRequest request, bool aside) {
  running_ = Running{request, aside};
  if (!aside) emit started(request.quality);
  watcher_.setFuture(
      lane_.run<Outcome>([worker = worker_, request = std::move(request), aside](QPromise<Outcome>& promise) {
        promise.setProgressRange(0, request.settings.max_iterations);
        const auto on_iteration = [&promise](const IterationReport& report) {
          promise.setProgressValue(report.iteration);
          return promise.isCanceled() ? NextStep::kStop : NextStep::kContinue;
        };
        promise.addResult(guarded(
            [&] { return aside ? worker->solveAside(request, on_iteration) : worker->solve(request, on_iteration); }));
      }));
}

void SolveService::onFinished() {
  const Running finished = *std::exchange(running_, std::nullopt);
  const QFuture<Outcome> future = watcher_.future();
  const bool landed = !future.isCanceled() && future.resultCount() == 1;
  startNext();
  if (landed) {
    const Outcome outcome = future.result();
    if (outcome) {
      finished.aside ? emit solvedAside(*outcome) : emit solved(*outcome);
    } else {
      const SolveFailure failure{finished.request.revision, finished.request.map, outcome.error()};
      const bool full_one_follows = running_ && !running_->aside && running_->request.revision == failure.revision;
      if (finished.aside) {
        emit failedAside(failure);
      } else if (!full_one_follows) {
        emit failed(failure);
      }
    }
  }
  if (!isBusy()) emit idle();
}

void SolveService::requestSigma(const std::string& map, const QPointF& point_in_blueprint) {
  stopAside();  // somebody waits for the answer
  auto* watcher = new QFutureWatcher<double>(this);
  connect(watcher, &QFutureWatcher<double>::finished, this, [this, watcher, point_in_blueprint] {
    watcher->deleteLater();
    if (watcher->future().resultCount() == 1) emit sigmaKnown(point_in_blueprint, watcher->result());
  });
  watcher->setFuture(
      lane_.run<double>([worker = worker_, map, point = toEigen(point_in_blueprint)](QPromise<double>& promise) {
        const Result<double> sigma = guarded([&]() -> Result<double> { return worker->sigma(map, point); });
        promise.addResult(sigma.value_or(std::numeric_limits<double>::quiet_NaN()));
      }));
}

}  // namespace cad2slam
