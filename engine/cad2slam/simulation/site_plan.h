// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include <vector>

#include "cad2slam/geometry/similarity2.h"
#include "cad2slam/map/occupancy_grid.h"
#include "cad2slam/simulation/seeded_random.h"

namespace cad2slam {

/// Upright rectangle of the plan frame [m].
struct Box {
  Eigen::Vector2d low = Eigen::Vector2d::Zero();
  Eigen::Vector2d high = Eigen::Vector2d::Zero();

  [[nodiscard]] Eigen::Vector2d center() const { return 0.5 * (low + high); }
  [[nodiscard]] Eigen::Vector2d size() const { return high - low; }
  [[nodiscard]] bool contains(const Eigen::Vector2d& point) const {
    return (point.array() >= low.array()).all() && (point.array() < high.array()).all();
  }
  [[nodiscard]] Box grownBy(double margin) const { return {low.array() - margin, high.array() + margin}; }
};

enum class SpaceUse { kRoom, kCorridor, kHall };

struct Space {
  Box box;
  SpaceUse use = SpaceUse::kRoom;
};

/// An opening through a wall. `inside` is a place in the room it belongs to, `outside` one on the other side.
struct Doorway {
  Box opening;
  bool wall_along_x = true;  ///< the wall it is in runs along the x axis
  Eigen::Vector2d inside = Eigen::Vector2d::Zero();
  Eigen::Vector2d outside = Eigen::Vector2d::Zero();
};

enum class SiteKind {
  kFlat,      ///< a few small rooms around a hallway
  kOffice,    ///< rooms on both sides of one or several parallel corridors, linked at their ends
  kCorridor,  ///< one long corridor (straight, L, U or ring) with side rooms
  kHall,      ///< a hall with racks and pillars, and a strip of offices
};

enum class CorridorShape { kStraight, kL, kU, kRing };

/// A building as an architect draws it. Plan frame: metres of the real building, interior from (0, 0) to `size_m`.
struct SitePlan {
  SiteKind kind = SiteKind::kOffice;
  Eigen::Vector2d size_m = Eigen::Vector2d::Zero();
  double outer_wall_m = 0.35;
  std::vector<Space> spaces;
  std::vector<Doorway> doors;
  std::vector<Box> solids;             ///< pillars and racks: in the drawing and in reality
  std::vector<Box> windows;            ///< parts of the outer wall that are drawn as outside: the wall is thinner there
  std::vector<Eigen::Vector2d> route;  ///< the main way through the building
  bool route_is_closed = false;        ///< it ends where it starts, so that a robot closes a loop

  /// Interior and not solid: where a robot can be.
  [[nodiscard]] bool isFree(const Eigen::Vector2d& point_m) const;
  /// Corners of walls, door frames, pillars and racks: the places an installer clicks.
  [[nodiscard]] std::vector<Eigen::Vector2d> corners() const;
};

struct SitePlanRecipe {
  SiteKind kind = SiteKind::kOffice;
  Eigen::Vector2d size_m = {45.0, 25.0};
  CorridorShape shape = CorridorShape::kU;  ///< of kCorridor
};

/// A random building. The same recipe and random numbers give the same building.
[[nodiscard]] SitePlan makeSitePlan(const SitePlanRecipe& recipe, SeededRandom& random);

/// The drawing as a raster of states: spaces free, walls and solids occupied, the rest unknown.
[[nodiscard]] OccupancyGrid drawPlan(const SitePlan& plan, const MapFrame& frame, const Similarity2& frame_from_plan);

/// Sets the pixels whose centres lie in a box.
void fillBox(cv::Mat& states, const MapFrame& frame, const Similarity2& frame_from_plan, const Box& box,
             CellState state);

}  // namespace cad2slam
