// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/services/solve_service.h"

#include "ui/convert.h"
#include "ui/services/guarded.h"
#include "ui/services/solve_worker.h"

#include <QPromise>
#include <QtConcurrent>

#include <utility>

namespace cad2slam {

SolveService::SolveService(QObject* parent) : QObject(parent), worker_(std::make_shared<SolveWorker>()) {
  lane_.setMaxThreadCount(1);
  connect(&watcher_, &QFutureWatcher<Outcome>::finished, this, &SolveService::onFinished);
  connect(&watcher_, &QFutureWatcher<Outcome>::progressValueChanged, this, &SolveService::progressed);
}

SolveService::~SolveService() {
  cancel();
  watcher_.disconnect(this);
  watcher_.waitForFinished();
  lane_.waitForDone();
}

void SolveService::request(SolveRequest request) {
  if (!running_) return start(std::move(request));
  if (running_->quality == Quality::kFull) watcher_.cancel();
  waiting_ = std::move(request);
}

void SolveService::cancel() {
  waiting_.reset();
  if (running_) watcher_.cancel();
}

void SolveService::start(SolveRequest request) {
  running_ = Running{request.quality, request.revision, request.map};
  emit started(request.quality);
  watcher_.setFuture(
      QtConcurrent::run(&lane_, [worker = worker_, request = std::move(request)](QPromise<Outcome>& promise) {
        if (promise.isCanceled()) return;
        promise.setProgressRange(0, request.settings.max_iterations);
        const auto on_iteration = [&promise](const IterationReport& report) {
          promise.setProgressValue(report.iteration);
          return promise.isCanceled() ? NextStep::kStop : NextStep::kContinue;
        };
        promise.addResult(guarded([&] { return worker->solve(request, on_iteration); }));
      }));
}

void SolveService::onFinished() {
  const Running finished = *std::exchange(running_, std::nullopt);
  const QFuture<Outcome> future = watcher_.future();
  const bool landed = !future.isCanceled() && future.resultCount() == 1;
  if (waiting_) start(*std::exchange(waiting_, std::nullopt));
  if (landed) {
    const Outcome outcome = future.result();
    if (outcome) {
      emit solved(*outcome);
    } else {
      emit failed({finished.revision, finished.map, outcome.error()});
    }
  }
  if (!running_) emit idle();
}

void SolveService::requestSigma(const std::string& map, const QPointF& point_in_blueprint) {
  auto* watcher = new QFutureWatcher<double>(this);
  connect(watcher, &QFutureWatcher<double>::finished, this, [this, watcher, point_in_blueprint] {
    watcher->deleteLater();
    if (watcher->future().resultCount() == 1) emit sigmaKnown(point_in_blueprint, watcher->result());
  });
  watcher->setFuture(QtConcurrent::run(&lane_, [worker = worker_, map, point = toEigen(point_in_blueprint)] {
    const Result<double> sigma = guarded([&]() -> Result<double> { return worker->sigma(map, point); });
    return sigma.value_or(std::numeric_limits<double>::quiet_NaN());
  }));
}

}  // namespace cad2slam
