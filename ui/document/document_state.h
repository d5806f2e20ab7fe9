// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cad2slam/anchors/anchor.h"
#include "cad2slam/io/project_file.h"

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace cad2slam {

/// Which half of an anchor.
enum class Side { kBlueprint, kSlam };

inline Side otherSide(Side side) {
  return side == Side::kBlueprint ? Side::kSlam : Side::kBlueprint;
}
inline const Eigen::Vector2d& half(const Anchor& anchor, Side side) {
  return side == Side::kBlueprint ? anchor.in_blueprint : anchor.in_slam;
}
inline Eigen::Vector2d& half(Anchor& anchor, Side side) {
  return side == Side::kBlueprint ? anchor.in_blueprint : anchor.in_slam;
}

/// Whether each pixel lies at the same metres in both.
inline bool isSameFrame(const MapMetadata& a, const MapMetadata& b) {
  return a.mirrored == b.mirrored && a.resolution_m_per_px == b.resolution_m_per_px &&
         a.metric_from_corner.translation == b.metric_from_corner.translation &&
         a.metric_from_corner.heading == b.metric_from_corner.heading;
}

/// Takes over what is known of the same image, where nothing is recorded yet.
inline void describeLike(ProjectRaster& raster, const ProjectRaster& known) {
  if (raster.metadata.image != known.metadata.image || !raster.image_sha256.empty()) return;
  raster.image_bytes = known.image_bytes;
  raster.image_sha256 = known.image_sha256;
}

/// Where "ok" ends and where "look" ends: the larger of a number of SLAM map pixels and a length.
struct ClassLimits {
  double ok_cells = 2.0;
  double ok_m = 0.15;
  double look_cells = 4.0;
  double look_m = 0.30;

  friend bool operator==(const ClassLimits&, const ClassLimits&) = default;
};

/// Everything that undo and redo restore.
struct DocumentState {
  Project project;
  AnchorId next_id = 1;  ///< of all SLAM maps together; deleting an anchor does not give its number back
  ClassLimits limits;
  std::map<std::string, std::set<AnchorId>> snapped;  ///< by SLAM map: anchors with a half placed on a found corner
};

/// `wanted`, or where files cannot hold that, the lowest number that is not taken.
[[nodiscard]] AnchorId freeAnchorId(AnchorId wanted, const std::set<AnchorId>& taken);

/// Adding, removing or editing one anchor; which of them, the presence of the two values says.
struct AnchorChange {
  std::size_t index = 0;  ///< place in the list: before for a removal, after for an addition
  std::optional<Anchor> before;
  std::optional<Anchor> after;
  bool snapped_before = false;
  bool snapped_after = false;

  [[nodiscard]] AnchorId id() const { return before ? before->id : after->id; }
};

}  // namespace cad2slam
