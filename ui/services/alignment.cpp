// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/services/alignment.h"

#include <algorithm>
#include <utility>

namespace cad2slam {
namespace {

constexpr double kSlow_s = 0.5;  // an edit whose answer would take longer is answered roughly first

bool isSameQuestion(const SolveRequest& a, const SolveRequest& b) {
  return a.anchors == b.anchors && a.settings == b.settings && a.cell_size_m == b.cell_size_m &&
         a.blueprint == b.blueprint;
}
bool answers(const SolveResult& result, const SolveRequest& request) {
  return result.quality == Quality::kFull && result.anchors == request.anchors && result.settings == request.settings &&
         result.cell_size_m == request.cell_size_m;
}
bool hasEnabled(const AnchorList& anchors) {
  return std::any_of(anchors.begin(), anchors.end(), [](const Anchor& anchor) { return anchor.enabled; });
}

}  // namespace

Alignment::Alignment(ProjectDocument& document, QObject* parent) : QObject(parent), document_(document) {
  connect(&document_, &ProjectDocument::changed, this, &Alignment::onChanged);
  connect(&service_, &SolveService::progressed, this, &Alignment::progressed);
  connect(&service_, &SolveService::sigmaKnown, this, &Alignment::sigmaKnown);
  connect(&service_, &SolveService::solved, this, [this](const SolveResultPtr& result) {
    if (result->map != document_.currentMapName() || status_ == AlignmentStatus::kNoAnchors) return;
    if (result_ && result->revision < result_->revision) return;
    if (result->quality == Quality::kPreview && isCurrent()) return;  // solved again: no way back to a rough one
    error_.reset();
    if (result->quality == Quality::kFull) full_solve_s_ = result->seconds;
    setResult(result);
    if (isCurrent()) setStatus(AlignmentStatus::kUpToDate);
  });
  connect(&service_, &SolveService::failed, this, [this](const SolveFailure& failure) {
    if (failure.revision != document_.revision() || failure.map != document_.currentMapName()) return;
    error_ = failure.error;
    failure.error.code == ErrorCode::kCancelled ? setStopped() : setStatus(AlignmentStatus::kFailed);
  });
  connect(&service_, &SolveService::solvedAside, this, [this](const SolveResultPtr& result) {
    const auto other = others_.find(result->map);
    if (other == others_.end() || !answers(*result, other->second.asked)) return;
    results_[result->map] = result;
    finishOther(result->map, AlignmentStatus::kUpToDate);
  });
  connect(&service_, &SolveService::failedAside, this, [this](const SolveFailure& failure) {
    const auto other = others_.find(failure.map);
    if (other == others_.end() || other->second.asked.revision != failure.revision) return;
    finishOther(failure.map, AlignmentStatus::kFailed);
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
  askOthers();
}

void Alignment::onChanged(const ChangeEvent& event) {
  if (event.what & (Change::kEverything | Change::kBlueprint)) {
    results_.clear();
    full_solve_s_ = 0.0;
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
  // A drag changes the current SLAM map alone.
  if (!event.interim && (event.needsSolve() || event.what & Change::kSlamMaps)) askOthers();
}

void Alignment::ask(Quality quality) {
  error_.reset();
  if (!blueprint_ || !slam_frame_ || !document_.currentMap()) {
    service_.cancel();
    setStatus(AlignmentStatus::kNotReady);
    return;
  }
  if (!hasEnabled(document_.anchors())) {
    service_.cancel();
    setStatus(AlignmentStatus::kNoAnchors);
    setResult(nullptr);
    return;
  }
  setStatus(AlignmentStatus::kSolving);
  SolveRequest request = requestFor(*document_.currentMap(), quality);
  request.preview_first = quality == Quality::kFull && full_solve_s_ > kSlow_s;
  service_.request(std::move(request));
}

SolveRequest Alignment::requestFor(const ProjectSlamMap& map, Quality quality) const {
  return {document_.revision(),
          map.name,
          blueprint_,
          map.name == document_.currentMapName() ? slam_frame_ : std::nullopt,
          map.anchors,
          document_.project().settings,
          document_.project().cell_size_m,
          quality};
}

void Alignment::askOthers() {
  std::map<std::string, Other> before = std::exchange(others_, {});
  if (!others_wanted_ || !blueprint_) {
    service_.cancelAside();
    if (!before.empty()) emit othersChanged();
    return;
  }
  for (const ProjectSlamMap& map : document_.project().slam_maps) {
    if (map.name == document_.currentMapName()) continue;
    Other& other = others_[map.name];
    other.asked = requestFor(map, Quality::kFull);
    const auto asked = before.find(map.name);
    const auto known = results_.find(map.name);
    if (!hasEnabled(map.anchors)) {
      other.status = AlignmentStatus::kNoAnchors;
      results_.erase(map.name);
    } else if (known != results_.end() && answers(*known->second, other.asked)) {
      other.status = AlignmentStatus::kUpToDate;
    } else if (asked != before.end() && isSameQuestion(asked->second.asked, other.asked)) {
      other = asked->second;  // on its way, or there is no answer
    } else {
      other.status = AlignmentStatus::kSolving;
      service_.requestAside(other.asked);
    }
  }
  emit othersChanged();
}

void Alignment::finishOther(const std::string& map, AlignmentStatus status) {
  others_[map].status = status;
  emit othersChanged();
}

void Alignment::setOthersWanted(bool wanted) {
  if (wanted == others_wanted_) return;
  others_wanted_ = wanted;
  askOthers();
}

AlignmentStatus Alignment::otherStatus(const std::string& map) const {
  const auto other = others_.find(map);
  return other == others_.end() ? AlignmentStatus::kNotReady : other->second.status;
}

bool Alignment::areOthersBusy() const {
  return std::any_of(others_.begin(), others_.end(),
                     [](const auto& entry) { return entry.second.status == AlignmentStatus::kSolving; });
}

void Alignment::solveNow() {
  ask(Quality::kFull);
  for (auto& [name, other] : others_)
    if (other.status != AlignmentStatus::kUpToDate) other = {};
  askOthers();
}

void Alignment::cancel() {
  if (areOthersBusy()) {
    service_.cancelAside();
    for (auto& [name, other] : others_)
      if (other.status == AlignmentStatus::kSolving) other.status = AlignmentStatus::kCancelled;
    emit othersChanged();
  }
  if (status_ != AlignmentStatus::kSolving) return;
  service_.cancel();
  setStopped();
}

void Alignment::requestSigma(const QPointF& point_in_blueprint) {
  service_.requestSigma(document_.currentMapName(), point_in_blueprint);
}

void Alignment::setStopped() {
  // What was merely solved again has its answer.
  setStatus(isCurrent() ? AlignmentStatus::kUpToDate : AlignmentStatus::kCancelled);
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
