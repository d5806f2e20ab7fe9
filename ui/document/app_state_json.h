// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/document/document_state.h"

#include <QJsonObject>

#include <string>

namespace cad2slam {

/// What the app keeps in a project's `view_state_json`. Anything unreadable falls back to its default: the text comes
/// from a file, and the look of the window must never keep a project from opening.
struct AppState {
  AnchorId next_id = 1;
  ClassLimits limits;
  std::map<std::string, std::set<AnchorId>> snapped;
  bool locked = false;
  std::string current_map;
  QJsonObject views;
};

[[nodiscard]] AppState appStateFromJson(const std::string& json);
/// `read`: as it stood in the file, of which the keys of newer versions survive.
[[nodiscard]] std::string appStateToJson(const AppState& state, const std::string& read);

}  // namespace cad2slam
