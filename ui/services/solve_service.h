// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/services/solve_types.h"
#include "ui/views/lane.h"

#include <QFutureWatcher>
#include <QObject>
#include <QPointF>

#include <deque>
#include <memory>
#include <optional>

namespace cad2slam {

class SolveWorker;

/// Solves in a thread of its own; the newest request wins. A running full solve is cancelled by any newer request; a
/// running preview is short and may land, so that a drag is never starved. Results come in the order of their
/// revisions, never an older one after a newer one. All signals are emitted on the thread of this object. A request
/// with `preview_first` has two results of its revision, unless a newer one comes in between.
///
/// Other SLAM maps can be solved aside: in the same thread, only while nothing else is to be done, one request for
/// each map. A request stops the one that runs aside, which begins again afterwards.
class SolveService : public QObject {
  Q_OBJECT

 public:
  explicit SolveService(QObject* parent = nullptr);
  ~SolveService() override;

  void request(SolveRequest request);
  /// Drops what waits and stops what runs; a result that is already on its way is dropped as well. Leaves what is
  /// solved aside alone.
  void cancel();
  /// Solves when there is time. Replaces what was asked aside for the same SLAM map.
  void requestAside(SolveRequest request);
  /// The same as cancel(), for what is solved aside.
  void cancelAside();
  [[nodiscard]] bool isBusy() const { return running_.has_value() || waiting_.has_value() || !aside_.empty(); }

  /// Asks how well a place of the blueprint is known; answered by sigmaKnown() after what runs now.
  void requestSigma(const std::string& map, const QPointF& point_in_blueprint);

 signals:
  void started(cad2slam::Quality quality);
  void progressed(int iteration);
  void solved(const cad2slam::SolveResultPtr& result);
  void failed(const cad2slam::SolveFailure& failure);
  void solvedAside(const cad2slam::SolveResultPtr& result);
  void failedAside(const cad2slam::SolveFailure& failure);
  void idle();
  void sigmaKnown(const QPointF& point_in_blueprint, double sigma_m);

 private:
  using Outcome = Result<SolveResultPtr>;
  struct Running {
    SolveRequest request;
    bool aside = false;
  };

  void start(SolveRequest request, bool aside);
  void startNext();
  void stopAside();
  void onFinished();

  std::shared_ptr<SolveWorker> worker_;  // touched by the lane only
  Lane lane_{1, Lane::Threads::kOwn};
  QFutureWatcher<Outcome> watcher_;
  std::optional<Running> running_;
  std::optional<SolveRequest> waiting_;
  std::deque<SolveRequest> aside_;  // waiting
};

}  // namespace cad2slam

Q_DECLARE_METATYPE(cad2slam::Quality)
