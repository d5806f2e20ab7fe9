// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/simulation/site_plan.h"

#include <algorithm>
#include <cmath>

namespace cad2slam {
namespace {

constexpr double kInnerWall = 0.15;

/// A strip beside a corridor that is divided into rooms.
struct RoomRow {
  Box band;
  bool along_x = true;       ///< rooms stand side by side along the x axis
  bool doors_at_low = true;  ///< the corridor lies on the low side of the band (below, or to the left)
  bool has_facade = true;    ///< the side away from the corridor is an outer wall
  double room_min_m = 3.0;   ///< wanted width of the rooms
  double room_max_m = 7.0;
  double shared_door = 0.12;  ///< chance of a door between neighbours
};

/// Boxes of a row are made in row coordinates: `along` the row, `across` it.
Box rowBox(const RoomRow& row, double along_low, double along_high, double across_low, double across_high) {
  if (row.along_x) return {{along_low, across_low}, {along_high, across_high}};
  return {{across_low, along_low}, {across_high, along_high}};
}

void addWindows(SitePlan& plan, const RoomRow& row, double from, double to, SeededRandom& random) {
  const int along = row.along_x ? 0 : 1;
  const double facade = row.doors_at_low ? row.band.high[1 - along] : row.band.low[1 - along];
  const double recess = 0.6 * plan.outer_wall_m;
  const double near = row.doors_at_low ? facade + plan.outer_wall_m - recess : facade - plan.outer_wall_m;
  const int count = std::max(1, static_cast<int>((to - from) / 2.6));
  const double pitch = (to - from) / count;
  const double width = std::min(1.6, 0.62 * pitch);
  for (int i = 0; i < count; ++i) {
    if (random.chance(0.08)) continue;
    const double middle = from + (i + 0.5) * pitch;
    plan.windows.push_back(rowBox(row, middle - 0.5 * width, middle + 0.5 * width, near, near + recess));
  }
}

void addDoor(SitePlan& plan, const RoomRow& row, double from, double to, SeededRandom& random) {
  const int along = row.along_x ? 0 : 1;
  const double width = (to - from) > 6.0 && random.chance(0.4) ? 1.6 : random.uniform(0.9, 1.05);
  const double start = random.uniform(from + 0.3, std::max(from + 0.31, to - 0.3 - width));
  const double edge = row.doors_at_low ? row.band.low[1 - along] : row.band.high[1 - along];
  const double wall_low = row.doors_at_low ? edge - kInnerWall : edge;
  const double inward = row.doors_at_low ? 1.0 : -1.0;
  Doorway door;
  door.opening = rowBox(row, start, start + width, wall_low, wall_low + kInnerWall);
  door.wall_along_x = row.along_x;
  Eigen::Vector2d across = Eigen::Vector2d::Zero();
  across[1 - along] = inward * 0.8;
  door.inside = door.opening.center() + across;
  door.outside = door.opening.center() - across;
  plan.doors.push_back(door);
}

void addRoomRow(SitePlan& plan, const RoomRow& row, SeededRandom& random) {
  const int along = row.along_x ? 0 : 1;
  const double end = row.band.high[along];
  const double across_low = row.band.low[1 - along];
  const double across_high = row.band.high[1 - along];
  if (end - row.band.low[along] < 1.5 || across_high - across_low < 1.2) return;
  for (double from = row.band.low[along]; from < end - 0.5;) {
    double to = from + random.uniform(row.room_min_m, row.room_max_m);
    if (end - to < row.room_min_m) to = end;  // no narrow rest
    plan.spaces.push_back({rowBox(row, from, to, across_low, across_high), SpaceUse::kRoom});
    addDoor(plan, row, from, to, random);
    if (row.has_facade) addWindows(plan, row, from, to, random);
    if (to < end && random.chance(row.shared_door)) {
      const double middle = random.uniform(across_low + 0.9, std::max(across_low + 0.91, across_high - 0.9));
      Doorway door;
      door.opening = rowBox(row, to, to + kInnerWall, middle - 0.45, middle + 0.45);
      door.wall_along_x = !row.along_x;
      Eigen::Vector2d step = Eigen::Vector2d::Zero();
      step[along] = 0.8;
      door.inside = door.opening.center() + step;
      door.outside = door.opening.center() - step;
      plan.doors.push_back(door);
    }
    from = to + kInnerWall;
  }
}

void addCorridor(SitePlan& plan, const Box& box) {
  plan.spaces.push_back({box, SpaceUse::kCorridor});
}

void makeOffice(SitePlan& plan, bool is_flat, SeededRandom& random) {
  const double width = plan.size_m.x();
  const double height = plan.size_m.y();
  const int corridors = is_flat ? 1 : std::max(1, static_cast<int>(std::lround(height / 14.0)));
  const double corridor_width = is_flat ? random.uniform(1.3, 1.6) : random.uniform(1.8, 2.4);
  const double module = height / corridors;
  RoomRow row;
  row.room_min_m = is_flat ? 2.4 : 3.0;
  row.room_max_m = is_flat ? 4.6 : 6.5;

  std::vector<double> middles;  // of the corridors, from below
  for (int i = 0; i < corridors; ++i) {
    const double shift = random.uniform(-0.08, 0.08) * module;
    middles.push_back((i + 0.5) * module + shift);
    addCorridor(plan, {{0.0, middles.back() - 0.5 * corridor_width}, {width, middles.back() + 0.5 * corridor_width}});
  }
  const double link_width = corridor_width;
  for (int i = 0; i < corridors; ++i) {
    const double low_edge = middles[i] - 0.5 * corridor_width - kInnerWall;
    const double high_edge = middles[i] + 0.5 * corridor_width + kInnerWall;
    const bool first = i == 0;
    const bool last = i + 1 == corridors;
    const double below = first ? 0.0 : 0.5 * (middles[i - 1] + middles[i]) + 0.5 * kInnerWall;
    const double above = last ? height : 0.5 * (middles[i] + middles[i + 1]) - 0.5 * kInnerWall;
    const double inset = link_width + kInnerWall;  // rooms between two corridors leave space for the links
    row.doors_at_low = false;
    row.has_facade = first;
    row.band = {{first ? 0.0 : inset, below}, {first ? width : width - inset, low_edge}};
    addRoomRow(plan, row, random);
    row.doors_at_low = true;
    row.has_facade = last;
    row.band = {{last ? 0.0 : inset, high_edge}, {last ? width : width - inset, above}};
    addRoomRow(plan, row, random);
  }
  if (corridors > 1) {
    addCorridor(plan, {{0.0, middles.front()}, {link_width, middles.back()}});
    addCorridor(plan, {{width - link_width, middles.front()}, {width, middles.back()}});
  }
  const double left = 0.5 * link_width;
  const double right = width - 0.5 * link_width;
  for (int i = 0; i < corridors; ++i) {  // to and fro like an ox ploughs
    plan.route.emplace_back(i % 2 == 0 ? left : right, middles[i]);
    plan.route.emplace_back(i % 2 == 0 ? right : left, middles[i]);
  }
  if (corridors > 1) {
    if (corridors % 2 == 1) plan.route.emplace_back(left, middles.back());
    plan.route.push_back(plan.route.front());
    plan.route_is_closed = true;
  }
}

void makeCorridor(SitePlan& plan, CorridorShape shape, SeededRandom& random) {
  const double width = plan.size_m.x();
  const double height = plan.size_m.y();
  const double corridor_width = random.uniform(2.2, 3.0);
  const double depth = std::min({random.uniform(4.0, 6.5), 0.25 * height, 0.25 * width});
  const double edge = depth + kInnerWall;  // the corridor's outer side, measured from the facade
  const double inner = edge + corridor_width + kInnerWall;
  const double middle = edge + 0.5 * corridor_width;
  const bool has_left = shape != CorridorShape::kStraight;
  const bool has_right = shape == CorridorShape::kU || shape == CorridorShape::kRing;
  const bool has_bottom = shape == CorridorShape::kRing;
  const double bottom = has_bottom ? edge : 0.0;
  const double left = has_left ? edge : 0.0;
  const double right = has_right ? width - edge : width;

  addCorridor(plan, {{left, height - edge - corridor_width}, {right, height - edge}});  // top leg
  if (has_left) addCorridor(plan, {{edge, bottom}, {edge + corridor_width, height - edge}});
  if (has_right) addCorridor(plan, {{width - edge - corridor_width, bottom}, {width - edge, height - edge}});
  if (has_bottom) addCorridor(plan, {{edge, edge}, {width - edge, edge + corridor_width}});

  RoomRow row;
  row.room_max_m = 9.0;
  row.band = {{left, height - depth}, {right, height}};
  row.doors_at_low = true;
  addRoomRow(plan, row, random);
  const double inner_depth = std::min(depth, random.uniform(3.5, 5.5));
  const double inner_end = height - inner;
  if (random.chance(0.8)) {  // rooms on the inner side of the top leg
    row.doors_at_low = false;
    row.band = {{has_left ? inner : left, inner_end - inner_depth}, {has_right ? width - inner : right, inner_end}};
    addRoomRow(plan, row, random);
  }
  row.along_x = false;
  if (has_left) {
    row.doors_at_low = false;
    row.band = {{0.0, bottom}, {depth, height - edge}};
    addRoomRow(plan, row, random);
  }
  if (has_right) {
    row.doors_at_low = true;
    row.band = {{width - depth, bottom}, {width, height - edge}};
    addRoomRow(plan, row, random);
  }
  if (has_bottom) {
    row.along_x = true;
    row.doors_at_low = false;
    row.band = {{edge, 0.0}, {width - edge, depth}};
    addRoomRow(plan, row, random);
  }

  const double top_y = height - middle;
  const double low_y = has_bottom ? middle : 1.0;
  if (has_left) plan.route.emplace_back(middle, low_y);
  plan.route.emplace_back(has_left ? middle : 1.0, top_y);
  plan.route.emplace_back(has_right ? width - middle : width - 1.0, top_y);
  if (has_right) plan.route.emplace_back(width - middle, low_y);
  if (has_bottom) {
    plan.route.push_back(plan.route.front());
    plan.route_is_closed = true;
  }
}

void makeHall(SitePlan& plan, SeededRandom& random) {
  const double width = plan.size_m.x();
  const double height = plan.size_m.y();
  const double strip = std::min(random.uniform(3.5, 5.0), 0.2 * height);
  const double hall_top = height - strip - kInnerWall;
  plan.spaces.push_back({{{0.0, 0.0}, {width, hall_top}}, SpaceUse::kHall});
  RoomRow row;
  row.room_max_m = 8.0;
  row.band = {{0.0, height - strip}, {width, height}};
  addRoomRow(plan, row, random);

  const double margin = std::min(4.0, 0.12 * hall_top);
  const double aisle = random.uniform(2.8, 3.6);
  const double rack = random.uniform(1.1, 2.2);
  const double cross = random.uniform(3.0, 4.5);  // width of the ways across the racks
  const double rack_length = std::max(4.0, random.uniform(10.0, 18.0));
  std::vector<double> aisles = {0.5 * margin};
  for (double y = margin; y + rack <= hall_top - margin; y += rack + aisle) {
    for (double x = cross; x + 3.0 < width - cross; x += rack_length + cross) {
      const double end = std::min(x + rack_length, width - cross);
      if (!random.chance(0.12)) plan.solids.push_back({{x, y}, {end, y + rack}});
    }
    aisles.push_back(std::min(y + rack + 0.5 * aisle, hall_top - 0.5 * margin));
  }
  for (double x = random.uniform(7.0, 9.0); x < width - 2.0; x += 10.0) {  // pillars along both long walls
    plan.solids.push_back({{x, 0.0}, {x + 0.5, 0.35}});
    const Box pillar{{x, hall_top - 0.35}, {x + 0.5, hall_top}};
    const bool blocks_a_door = std::any_of(plan.doors.begin(), plan.doors.end(), [&](const Doorway& door) {
      return pillar.grownBy(1.1).contains(door.opening.center());
    });
    if (!blocks_a_door) plan.solids.push_back(pillar);
  }
  const double left = 0.5 * cross;
  const double right = width - 0.5 * cross;
  for (std::size_t i = 0; i < aisles.size(); ++i) {
    plan.route.emplace_back(i % 2 == 0 ? left : right, aisles[i]);
    plan.route.emplace_back(i % 2 == 0 ? right : left, aisles[i]);
  }
  if (aisles.size() % 2 == 1) plan.route.emplace_back(left, aisles.back());
  plan.route.push_back(plan.route.front());
  plan.route_is_closed = true;
}

}  // namespace

bool SitePlan::isFree(const Eigen::Vector2d& point_m) const {
  const auto holds = [&](const Box& box) { return box.contains(point_m); };
  if (std::any_of(solids.begin(), solids.end(), holds)) return false;
  return std::any_of(spaces.begin(), spaces.end(), [&](const Space& space) { return holds(space.box); }) ||
         std::any_of(doors.begin(), doors.end(), [&](const Doorway& door) { return holds(door.opening); });
}

std::vector<Eigen::Vector2d> SitePlan::corners() const {
  std::vector<Eigen::Vector2d> found;
  const auto add_corners = [&](const Box& box) {
    for (const Eigen::Vector2d& corner :
         {box.low, Eigen::Vector2d(box.high.x(), box.low.y()), box.high, Eigen::Vector2d(box.low.x(), box.high.y())}) {
      // A corner of the drawing has one free quadrant (a room's) or three (a pillar's); walls and openings have two.
      constexpr double kBeside = 0.05;
      int free_quadrants = 0;
      for (const double dx : {-kBeside, kBeside}) {
        for (const double dy : {-kBeside, kBeside}) free_quadrants += isFree(corner + Eigen::Vector2d(dx, dy)) ? 1 : 0;
      }
      const bool is_new = std::none_of(found.begin(), found.end(),
                                       [&](const Eigen::Vector2d& other) { return (other - corner).norm() < kBeside; });
      if (is_new && free_quadrants % 2 == 1) found.push_back(corner);
    }
  };
  for (const Space& space : spaces) add_corners(space.box);
  for (const Doorway& door : doors) add_corners(door.opening);
  for (const Box& solid : solids) add_corners(solid);
  return found;
}

SitePlan makeSitePlan(const SitePlanRecipe& recipe, SeededRandom& random) {
  SitePlan plan;
  plan.kind = recipe.kind;
  plan.size_m = recipe.size_m;
  plan.outer_wall_m = recipe.kind == SiteKind::kFlat ? 0.25 : 0.35;
  switch (recipe.kind) {
    case SiteKind::kFlat:
    case SiteKind::kOffice:
      makeOffice(plan, recipe.kind == SiteKind::kFlat, random);
      break;
    case SiteKind::kCorridor:
      makeCorridor(plan, recipe.shape, random);
      break;
    case SiteKind::kHall:
      makeHall(plan, random);
      break;
  }
  return plan;
}

void fillBox(cv::Mat& states, const MapFrame& frame, const Similarity2& frame_from_plan, const Box& box,
             CellState state) {
  const Eigen::Vector2d first_px = frame.pixelFromMetric(frame_from_plan * box.low);
  Eigen::Vector2d low_px = first_px;
  Eigen::Vector2d high_px = first_px;
  for (const Eigen::Vector2d& corner :
       {Eigen::Vector2d(box.high.x(), box.low.y()), box.high, Eigen::Vector2d(box.low.x(), box.high.y())}) {
    const Eigen::Vector2d pixel = frame.pixelFromMetric(frame_from_plan * corner);
    low_px = low_px.cwiseMin(pixel);
    high_px = high_px.cwiseMax(pixel);
  }
  const Similarity2 plan_from_frame = frame_from_plan.inverse();
  const int first_row = std::max(0, static_cast<int>(std::floor(low_px.y())));
  const int last_row = std::min(states.rows - 1, static_cast<int>(std::floor(high_px.y())));
  const int first_column = std::max(0, static_cast<int>(std::floor(low_px.x())));
  const int last_column = std::min(states.cols - 1, static_cast<int>(std::floor(high_px.x())));
  for (int row = first_row; row <= last_row; ++row) {
    for (int column = first_column; column <= last_column; ++column) {
      if (box.contains(plan_from_frame * frame.metricFromPixel({column + 0.5, row + 0.5}))) {
        states.at<std::uint8_t>(row, column) = static_cast<std::uint8_t>(state);
      }
    }
  }
}

OccupancyGrid drawPlan(const SitePlan& plan, const MapFrame& frame, const Similarity2& frame_from_plan) {
  cv::Mat states(frame.height(), frame.width(), CV_8UC1, cv::Scalar(static_cast<int>(CellState::kUnknown)));
  const auto fill = [&](const Box& box, CellState state) { fillBox(states, frame, frame_from_plan, box, state); };
  for (const Space& space : plan.spaces) fill(space.box.grownBy(plan.outer_wall_m), CellState::kOccupied);
  for (const Box& window : plan.windows) fill(window, CellState::kUnknown);
  for (const Space& space : plan.spaces) fill(space.box, CellState::kFree);
  for (const Doorway& door : plan.doors) fill(door.opening, CellState::kFree);
  for (const Box& solid : plan.solids) fill(solid, CellState::kOccupied);
  return {frame, states};
}

}  // namespace cad2slam
