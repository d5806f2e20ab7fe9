// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/document/project_document.h"

#include "ui/convert.h"
#include "ui/document/app_state_json.h"

#include <QCoreApplication>

#include <algorithm>
#include <utility>

namespace cad2slam {
namespace {

bool samePoints(const Anchor& a, const Anchor& b) {
  return a.in_blueprint == b.in_blueprint && a.in_slam == b.in_slam && a.enabled == b.enabled;
}

AnchorId largestId(const Project& project) {
  AnchorId largest = 0;
  for (const ProjectSlamMap& map : project.slam_maps)
    for (const Anchor& anchor : map.anchors) largest = std::max(largest, anchor.id);
  return largest;
}

/// Whether a place in one raster is the same place in the other: an image found again elsewhere is still the same.
bool isSameGround(const ProjectRaster& a, const ProjectRaster& b) {
  const bool same_image =
      a.metadata.image == b.metadata.image || (!a.image_sha256.empty() && a.image_sha256 == b.image_sha256);
  return same_image && isSameFrame(a.metadata, b.metadata);
}

/// The map before a step that is `map` after it: the one of its name, or the one that was renamed.
const ProjectSlamMap* sameMapIn(const Project& before, const ProjectSlamMap& map, const Project& after) {
  const auto named = [](const Project& project, const std::string& name) -> const ProjectSlamMap* {
    for (const ProjectSlamMap& each : project.slam_maps)
      if (each.name == name) return &each;
    return nullptr;
  };
  if (const ProjectSlamMap* same = named(before, map.name)) return same;
  for (const ProjectSlamMap& each : before.slam_maps)
    if (each.raster.metadata.image == map.raster.metadata.image && !named(after, each.name)) return &each;
  return nullptr;
}

}  // namespace

AnchorId freeAnchorId(AnchorId wanted, const std::set<AnchorId>& taken) {
  if (wanted <= kLargestAnchorId) return wanted;
  AnchorId id = 1;
  while (taken.contains(id)) ++id;
  return id;
}

ProjectDocument::ProjectDocument(QObject* parent) : QObject(parent) {
  undo_stack_.setUndoLimit(10'000);
  connect(&undo_stack_, &QUndoStack::cleanChanged, this, [this] { announce({Change::kSavedState, {}, {}, {}}); });
}

ProjectDocument::~ProjectDocument() {
  // A stack with unsaved edits reports itself clean while it goes away; by then the listeners are half gone.
  undo_stack_.disconnect();
}

const ProjectSlamMap* ProjectDocument::currentMap() const {
  const auto& maps = project().slam_maps;
  const auto found = std::find_if(maps.begin(), maps.end(), [&](const auto& map) { return map.name == current_map_; });
  if (found != maps.end()) return &*found;
  return maps.empty() ? nullptr : &maps.front();
}

std::string ProjectDocument::currentMapName() const {
  const ProjectSlamMap* map = currentMap();
  return map ? map->name : std::string();
}

ProjectSlamMap* ProjectDocument::mapNamed(const std::string& name) {
  for (ProjectSlamMap& map : state_.project.slam_maps)
    if (map.name == name) return &map;
  return nullptr;
}

void ProjectDocument::setCurrentMap(const std::string& name) {
  if (name == currentMapName() || !mapNamed(name)) return;
  current_map_ = name;
  ++revision_;
  announce({Change::kCurrentMap | Change::kAnchors | Change::kPending, {}, {}, {}});
}

const AnchorList& ProjectDocument::anchors() const {
  static const AnchorList kNone;
  const ProjectSlamMap* map = currentMap();
  return map ? map->anchors : kNone;
}

const Anchor* ProjectDocument::anchor(AnchorId id) const {
  for (const Anchor& anchor : anchors())
    if (anchor.id == id) return &anchor;
  return nullptr;
}

AnchorId ProjectDocument::nextId() const {
  if (state_.next_id <= kLargestAnchorId) return state_.next_id;
  std::set<AnchorId> taken;
  for (const Anchor& anchor : anchors()) taken.insert(anchor.id);
  return freeAnchorId(state_.next_id, taken);
}

bool ProjectDocument::isSnapped(AnchorId id) const {
  const auto found = state_.snapped.find(currentMapName());
  return found != state_.snapped.end() && found->second.contains(id);
}

std::optional<PendingAnchor> ProjectDocument::pending() const {
  const ProjectSlamMap* map = currentMap();
  return map ? map->pending : std::nullopt;
}

void ProjectDocument::setPending(std::optional<PendingAnchor> pending) {
  ProjectSlamMap* map = mapNamed(currentMapName());
  if (!map || (!map->pending && !pending)) return;
  map->pending = pending;
  announce({Change::kPending | Change::kSavedState, {}, {}, {}});
}

void ProjectDocument::setLocked(bool locked) {
  if (locked == locked_) return;
  locked_ = locked;
  announce({Change::kPreferences | Change::kSavedState, {}, {}, {}});
}

bool ProjectDocument::mayEditAnchors() {
  if (locked_) emit editRefused();
  return !locked_;
}

std::map<std::string, PendingAnchor> ProjectDocument::pendingOfAllMaps() const {
  std::map<std::string, PendingAnchor> pending;
  for (const ProjectSlamMap& map : project().slam_maps)
    if (map.pending) pending.emplace(map.name, *map.pending);
  return pending;
}

void ProjectDocument::reset(Project project, const std::filesystem::path& path, bool recovered) {
  undo_stack_.clear();
  const AppState app = appStateFromJson(project.view_state_json);
  state_ = DocumentState{};
  state_.next_id = std::max(app.next_id, largestId(project) + 1);
  state_.limits = app.limits;
  state_.snapped = app.snapped;
  state_.project = std::move(project);
  view_state_ = app.views;
  locked_ = app.locked;
  current_map_ = app.current_map;
  path_ = path;
  never_saved_ = recovered;
  saved_locked_ = locked_;
  saved_pending_ = pendingOfAllMaps();
  ++revision_;
  announce({Change::kEverything | Change::kSavedState | Change::kAnchors | Change::kPending, {}, {}, {}});
}

void ProjectDocument::markSaved(const std::filesystem::path& path) {
  path_ = path;
  never_saved_ = false;
  saved_locked_ = locked_;
  saved_pending_ = pendingOfAllMaps();
  undo_stack_.setClean();
  announce({Change::kSavedState, {}, {}, {}});
}

void ProjectDocument::describeRasters(const std::string& map_name, const ProjectRaster& blueprint,
                                      const ProjectRaster& slam) {
  describeLike(state_.project.blueprint, blueprint);
  if (ProjectSlamMap* map = mapNamed(map_name)) describeLike(map->raster, slam);
}

bool ProjectDocument::isModified() const {
  return never_saved_ || !undo_stack_.isClean() || locked_ != saved_locked_ || pendingOfAllMaps() != saved_pending_;
}

Project ProjectDocument::projectToSave() const {
  Project result = state_.project;
  AppState app;
  app.next_id = state_.next_id;
  app.limits = state_.limits;
  app.snapped = state_.snapped;
  app.locked = locked_;
  app.current_map = currentMapName();
  app.views = view_state_;
  result.view_state_json = appStateToJson(app, result.view_state_json);
  if (!path_.empty()) result.name = toStd(toQString(path_.stem()));
  result.app_version = toStd(QCoreApplication::applicationVersion());
  return result;
}

void ProjectDocument::applyAnchorChanges(const std::string& map_name, const std::vector<AnchorChange>& changes,
                                         AnchorId next_id, Direction direction, ChangeEvent event) {
  ProjectSlamMap* map = mapNamed(map_name);
  Q_ASSERT(map);
  AnchorList& anchors = map->anchors;
  std::set<AnchorId>& snapped = state_.snapped[map_name];
  bool points_changed = false;
  const auto apply = [&](const AnchorChange& change) {
    const bool redo = direction == Direction::kRedo;
    const std::optional<Anchor>& from = redo ? change.before : change.after;
    const std::optional<Anchor>& to = redo ? change.after : change.before;
    if (from && to) {
      points_changed |= !samePoints(*from, *to);
      anchors[change.index] = *to;
      event.edited.push_back(to->id);
    } else if (to) {
      anchors.insert(anchors.begin() + static_cast<std::ptrdiff_t>(change.index), *to);
      event.added.push_back(to->id);
    } else {
      anchors.erase(anchors.begin() + static_cast<std::ptrdiff_t>(change.index));
      event.removed.push_back(from->id);
    }
    const bool is_snapped = redo ? change.snapped_after : change.snapped_before;
    if (to && is_snapped) {
      snapped.insert(change.id());
    } else {
      snapped.erase(change.id());
    }
  };
  // Additions go in from the front and removals from the back, so that each index is right at its turn.
  const bool adds =
      !changes.empty() && !(direction == Direction::kRedo ? changes.front().before : changes.front().after);
  if (adds) {
    std::for_each(changes.begin(), changes.end(), apply);
  } else {
    std::for_each(changes.rbegin(), changes.rend(), apply);
  }
  if (snapped.empty()) state_.snapped.erase(map_name);
  state_.next_id = next_id;

  const bool needs_solve = points_changed || !event.added.empty() || !event.removed.empty();
  event.what |= needs_solve ? Change::kAnchors : Change::kAnchorTexts;
  if (map_name != currentMapName()) {  // undo of an edit of another SLAM map: show what is being undone
    current_map_ = map_name;
    event.what |= Change::kCurrentMap | Change::kAnchors | Change::kPending;
  }
  if (event.needsSolve()) ++revision_;
  announce(event);
}

void ProjectDocument::applyState(const DocumentState& state, const std::string& current_map, ChangeEvent event) {
  // The half anchor is not part of any command, so it stays, unless its ground has moved.
  const std::string before_name = currentMapName();
  const Project before = std::exchange(state_, state).project;
  // Size and hash of an image are no part of a command either; one that was chosen anew is found out anew.
  if (event.by_history) describeLike(state_.project.blueprint, before.blueprint);
  for (ProjectSlamMap& map : state_.project.slam_maps) {
    map.pending.reset();
    const ProjectSlamMap* old = sameMapIn(before, map, state_.project);
    if (old && event.by_history) describeLike(map.raster, old->raster);
    if (!old || !old->pending) continue;
    const bool in_blueprint = old->pending->in_blueprint;
    const bool stays =
        in_blueprint ? isSameGround(before.blueprint, state_.project.blueprint) : isSameGround(old->raster, map.raster);
    if (stays) map.pending = old->pending;
  }
  if (event.what & (Change::kBlueprint | Change::kSlamMaps)) event.what |= Change::kAnchors | Change::kPending;
  current_map_ = current_map;
  const ProjectSlamMap* now = currentMap();
  const ProjectSlamMap* now_before = now ? sameMapIn(before, *now, state_.project) : nullptr;
  // The map of the step need not be the one that was looked at last; one that was only renamed is no other map.
  if (before_name != (now_before ? now_before->name : std::string()))
    event.what |= Change::kCurrentMap | Change::kAnchors | Change::kPending;
  current_map_ = currentMapName();
  if (event.needsSolve()) ++revision_;
  announce(event);
}

void ProjectDocument::announce(const ChangeEvent& event) {
  emit changed(event);
}

}  // namespace cad2slam
