// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/document/anchor_selection.h"

#include <utility>

namespace cad2slam {

AnchorSelection::AnchorSelection(ProjectDocument& document, QObject* parent) : QObject(parent), document_(document) {
  connect(&document_, &ProjectDocument::changed, this, [this](const ChangeEvent& event) {
    if (event.by_history && !event.added.empty()) return set(event.added);
    // The same numbers are other anchors there.
    set(event.what & (Change::kEverything | Change::kCurrentMap) ? std::vector<AnchorId>() : ids_);
  });
}

std::optional<AnchorId> AnchorSelection::current() const {
  return ids_.empty() ? std::nullopt : std::optional(ids_.back());
}

void AnchorSelection::set(std::vector<AnchorId> ids) {
  std::erase_if(ids, [this](AnchorId id) { return !document_.anchor(id); });
  if (ids == ids_) return;
  ids_ = std::move(ids);
  emit changed();
}

void AnchorSelection::toggle(AnchorId id) {
  std::vector<AnchorId> ids = ids_;
  if (std::erase(ids, id) == 0) ids.push_back(id);
  set(std::move(ids));
}

}  // namespace cad2slam
