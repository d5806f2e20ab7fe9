// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/services/alignment.h"

#include <algorithm>
#include <utility>

namespace cad2slam {

Alignment::Alignment(ProjectDocument& document, QObject* parent) : QObject(parent), document_(document) {
  connect(&document_, &ProjectDocument::changed, this, &Alignment::onChanged);
  connect(&service_, &SolveService::progressed, this, &Alignment::progressed);
  connect(&service_, &SolveService::sigmaKnown, this, &Alignment::sigmaKnown);
  connect(&service_, &SolveService::solved, this, [this](const SolveResultPtr& result) {
    if (result->map != document_.currentMapName() || status_ == AlignmentStatus::kNoAnchors) return;
    if (result_ && result->revision < result_->revision) return;
    error_.reset();
    setResult(result);
    if (isCurrent()) setStatus(AlignmentStatus::kUpToDate);
  });
  connect(&service_, &SolveService::failed, this, [this](const SolveFailure& failure) {
    if (failure.revision != document_.revision() || failure.map != document_.currentMapName()) return;
    error_ = failure.error;
    setStatus(failure.error.code == ErrorCode::kCancelled ? AlignmentStatus::kCancelled : AlignmentStatus::kFailed);
  });
}

bool Alignment::isCurrent() const {
  return result_ && result_->revision == document_.revision() && result_->quality == Quality::kFull;
}

void Alignment::setImages(std::shared_ptr<const OccupancyGrid> blueprint, std::optional<MapFrame> slam_frame) {
  if (blueprint != blueprint_) results_.clear();
  blueprint_ = std::move(blueprint);
  slam_frame_ = std::move(slam_frame);
  ask(Quality::kFull);
}

void Alignment::onChanged(const ChangeEvent& event) {
  if (event.what & (Change::kEverything | Change::kBlueprint)) {
    results_.clear();
    service_.cancel();
    blueprint_.reset();  // comes back through setImages() as soon as it is loaded
    setResult(nullptr);
  } else if (event.what & Change::kCurrentMap) {
    const auto known = results_.find(document_.currentMapName());
    setResult(known == results_.end() ? nullptr : known->second);
  }
  if (event.what & Change::kSlamMaps)
    std::erase_if(results_, [&](const auto& entry) {
      const auto& maps = document_.project().slam_maps;
      return std::none_of(maps.begin(), maps.end(), [&](const auto& map) { return map.name == entry.first; });
    });
  if (event.needsSolve()) ask(event.interim ? Quality::kPreview : Quality::kFull);
}

void Alignment::ask(Quality quality) {
  error_.reset();
  if (!blueprint_ || !slam_frame_ || !document_.currentMap()) {
    service_.cancel();
    setStatus(AlignmentStatus::kNotReady);
    return;
  }
  const AnchorList& anchors = document_.anchors();
  if (std::none_of(anchors.begin(), anchors.end(), [](const Anchor& anchor) { return anchor.enabled; })) {
    service_.cancel();
    setStatus(AlignmentStatus::kNoAnchors);
    setResult(nullptr);
    return;
  }
  setStatus(AlignmentStatus::kSolving);
  service_.request({document_.revision(), document_.currentMapName(), blueprint_, slam_frame_, anchors,
                    document_.project().settings, document_.project().cell_size_m, quality});
}

void Alignment::solveNow() {
  ask(Quality::kFull);
}

void Alignment::cancel() {
  if (status_ != AlignmentStatus::kSolving) return;
  service_.cancel();
  setStatus(AlignmentStatus::kCancelled);
}

void Alignment::requestSigma(const QPointF& point_in_blueprint) {
  service_.requestSigma(document_.currentMapName(), point_in_blueprint);
}

void Alignment::setStatus(AlignmentStatus status) {
  status_ = status;
  emit statusChanged();
}

void Alignment::setResult(SolveResultPtr result) {
  if (result) {
    results_[result->map] = result;
  } else {
    results_.erase(document_.currentMapName());
  }
  if (!result && !result_) return;
  result_ = std::move(result);
  if (!result_ && status_ == AlignmentStatus::kUpToDate) status_ = AlignmentStatus::kNotReady;  // listeners rely on it
  emit resultChanged();
}

}  // namespace cad2slam
