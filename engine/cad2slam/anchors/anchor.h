// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <string>
#include <vector>

namespace cad2slam {

/// Identity of an anchor inside one set; what the installer sees as its number. Never reused by an editor.
using AnchorId = std::int64_t;

/// From 0 to this ids are read from files: JSON and spreadsheets keep them exactly.
inline constexpr AnchorId kLargestAnchorId = AnchorId{1} << 53;

/// Coordinates beyond this are typing errors, and doubles lose micrometres there [m].
inline constexpr double kLargestCoordinate = 1e9;

/// A point of the blueprint paired with the same real place in a SLAM map.
struct Anchor {
  AnchorId id = 0;
  Eigen::Vector2d in_blueprint = Eigen::Vector2d::Zero();  ///< [m]
  Eigen::Vector2d in_slam = Eigen::Vector2d::Zero();       ///< [m]
  bool enabled = true;                                     ///< a disabled anchor is kept and reported, not used
  std::string name;
  std::string note;

  friend bool operator==(const Anchor&, const Anchor&) = default;
};

using AnchorList = std::vector<Anchor>;

}  // namespace cad2slam
