// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cad2slam/anchors/anchor.h"

#include <QFlags>

#include <cstdint>
#include <vector>

namespace cad2slam {

/// What of a document changed. One edit may change several things and is announced once.
enum class Change : std::uint16_t {
  kEverything = 1 << 0,   ///< another project was loaded or created
  kAnchors = 1 << 1,      ///< anchors of the current SLAM map; see the id lists
  kPending = 1 << 2,      ///< the half anchor of the current SLAM map
  kSettings = 1 << 3,     ///< solver settings or cell size
  kBlueprint = 1 << 4,    ///< which blueprint raster, its scale or its orientation
  kSlamMaps = 1 << 5,     ///< the list of SLAM maps, their names or rasters
  kCurrentMap = 1 << 6,   ///< another SLAM map is being edited
  kSavedState = 1 << 7,   ///< path, name or modified flag
  kPreferences = 1 << 8,  ///< limits of the anchor classes and other app state kept in the project
  kAnchorTexts = 1 << 9,  ///< names or notes of anchors of the current SLAM map
};
Q_DECLARE_FLAGS(Changes, Change)
Q_DECLARE_OPERATORS_FOR_FLAGS(Changes)

struct ChangeEvent {
  Changes what;
  std::vector<AnchorId> added;    ///< new in the current SLAM map
  std::vector<AnchorId> removed;  ///< gone from it
  std::vector<AnchorId> edited;   ///< same id, other values
  bool interim = false;           ///< part of a gesture that still goes on (drag): a quick answer is wanted
  bool by_history = false;        ///< caused by undo or redo

  /// Whether results computed before are out of date.
  [[nodiscard]] bool needsSolve() const {
    return what &
           (Change::kEverything | Change::kAnchors | Change::kSettings | Change::kBlueprint | Change::kCurrentMap);
  }
};

}  // namespace cad2slam
