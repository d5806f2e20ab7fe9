// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "furnished_world.h"

#include "cad2slam/planning/grid_planner.h"

#include <algorithm>
#include <cmath>

namespace cad2slam::samples {
namespace {

constexpr double kResolution = 0.04;
constexpr double kMargin = 2.0;
constexpr double kRobotRadius = 0.24;

class Furnisher {
 public:
  Furnisher(const SitePlan& plan, SeededRandom& random) : plan_(plan), random_(random), frame_(makeFrame(plan)) {
    states_ = drawPlan(plan, frame_, {}).states();
  }

  FurnishedWorld run() {
    std::vector<bool> door_is_open;
    for (const Doorway& door : plan_.doors) door_is_open.push_back(hangDoor(door));
    for (const Space& space : plan_.spaces) {
      switch (space.use) {
        case SpaceUse::kRoom:
          furnishRoom(space.box);
          break;
        case SpaceUse::kCorridor:
          furnishCorridor(space.box);
          break;
        case SpaceUse::kHall:
          furnishHall(space.box);
          break;
      }
    }
    return {OccupancyGrid(frame_, states_), std::move(door_is_open)};
  }

 private:
  static MapFrame makeFrame(const SitePlan& plan) {
    const Eigen::Vector2d size_px = (plan.size_m + Eigen::Vector2d::Constant(2.0 * kMargin)) / kResolution;
    return *MapFrame::create(kResolution, static_cast<int>(size_px.x()), static_cast<int>(size_px.y()),
                             {{-kMargin, -kMargin}, 0.0});
  }

  void put(const Eigen::Vector2d& center, const Eigen::Vector2d& half_size, double heading = 0.0) {
    fillBox(states_, frame_, {1.0, heading, center}, {-half_size, half_size}, CellState::kOccupied);
  }

  /// An open leaf stands into the room; a shut one fills the opening.
  bool hangDoor(const Doorway& door) {
    if (random_.chance(0.12)) {
      put(door.opening.center(), 0.5 * door.opening.size());
      return false;
    }
    const int along = door.wall_along_x ? 0 : 1;
    const double width = door.opening.size()[along];
    const bool is_double = width > 1.2;
    const Eigen::Vector2d inward = (door.inside - door.outside).normalized();
    const Eigen::Vector2d unit = Eigen::Vector2d::Unit(along);
    for (const double side : {-1.0, 1.0}) {
      if (!is_double && side > 0.0) break;
      const double leaf = is_double ? 0.5 * width : width;
      const Eigen::Vector2d hinge = door.opening.center() + side * 0.5 * width * unit + 0.09 * inward;
      const double ajar = random_.uniform(1.2, 1.75);
      const Eigen::Vector2d direction = -side * std::cos(ajar) * unit + std::sin(ajar) * inward;
      put(hinge + 0.5 * leaf * direction, {0.5 * leaf, 0.03}, std::atan2(direction.y(), direction.x()));
    }
    return true;
  }

  [[nodiscard]] bool blocksADoor(const Eigen::Vector2d& place, double radius) const {
    return std::any_of(plan_.doors.begin(), plan_.doors.end(), [&](const Doorway& door) {
      return (door.inside - place).norm() < radius + 0.55 || (door.outside - place).norm() < radius + 0.55;
    });
  }

  void putDesk(const Eigen::Vector2d& center, double heading) {
    const Pose2 desk{center, heading};
    for (const double x : {-0.75, 0.75}) {  // legs; the LiDAR looks below the top
      for (const double y : {-0.35, 0.35}) put(desk * Eigen::Vector2d(x, y), {0.04, 0.04}, heading);
    }
    put(desk * Eigen::Vector2d(0.5, 0.0), {0.2, 0.3}, heading);
    const Eigen::Vector2d chair = desk * Eigen::Vector2d(random_.uniform(-0.3, 0.2), -0.7);
    for (int leg = 0; leg < 5; ++leg) {
      const double direction = 1.257 * leg + heading;
      put(chair + 0.26 * Eigen::Vector2d(std::cos(direction), std::sin(direction)), {0.035, 0.035}, direction);
    }
  }

  void furnishRoom(const Box& room) {
    const Eigen::Vector2d size = room.size();
    const int desks = static_cast<int>(size.prod() / 9.0);
    for (int i = 0; i < desks; ++i) {
      const Eigen::Vector2d place(
          random_.uniform(room.low.x() + 1.0, std::max(room.low.x() + 1.01, room.high.x() - 1.0)),
          random_.uniform(room.low.y() + 1.0, std::max(room.low.y() + 1.01, room.high.y() - 1.0)));
      if (!blocksADoor(place, 0.8)) putDesk(place, 0.5 * kPi * random_.integer(0, 3) + 0.05 * random_.normal());
    }
    putAlongWalls(room, static_cast<int>(size.sum() / 2.5), {0.5, 0.21});
  }

  void furnishCorridor(const Box& corridor) {
    putAlongWalls(corridor, static_cast<int>(corridor.size().maxCoeff() / 7.0), {0.45, 0.2});
  }

  /// Cabinets with their backs to the walls.
  void putAlongWalls(const Box& room, int count, const Eigen::Vector2d& half_size) {
    for (int i = 0; i < count; ++i) {
      const bool along_x = random_.chance(room.size().x() / room.size().sum());
      const int along = along_x ? 0 : 1;
      const bool low = random_.chance(0.5);
      Eigen::Vector2d place;
      place[along] = random_.uniform(room.low[along] + 0.6, std::max(room.low[along] + 0.61, room.high[along] - 0.6));
      place[1 - along] = low ? room.low[1 - along] + half_size.y() : room.high[1 - along] - half_size.y();
      if (blocksADoor(place, 0.6) || !plan_.isFree(place)) continue;
      put(place, {half_size.x() * random_.uniform(0.6, 1.3), half_size.y()}, along_x ? 0.0 : 0.5 * kPi);
    }
  }

  void furnishHall(const Box& hall) {
    const int pallets = static_cast<int>(hall.size().prod() / 45.0);
    for (int i = 0; i < pallets; ++i) {
      const Eigen::Vector2d place(random_.uniform(hall.low.x() + 0.7, hall.high.x() - 0.7),
                                  random_.uniform(hall.low.y() + 0.7, hall.high.y() - 0.7));
      const bool in_the_way = !isClear(place, 0.75) || nearRoute(place) < 1.25 || blocksADoor(place, 0.7);
      if (!in_the_way) put(place, {0.6, 0.4}, 0.5 * kPi * random_.integer(0, 1) + 0.15 * random_.normal());
    }
  }

  [[nodiscard]] bool isClear(const Eigen::Vector2d& place, double radius) const {
    for (double direction = 0.0; direction < 2.0 * kPi; direction += 0.5) {
      if (!plan_.isFree(place + radius * Eigen::Vector2d(std::cos(direction), std::sin(direction)))) return false;
    }
    return true;
  }

  [[nodiscard]] double nearRoute(const Eigen::Vector2d& place) const {
    double nearest = 1e9;
    for (std::size_t i = 1; i < plan_.route.size(); ++i) {
      const Eigen::Vector2d leg = plan_.route[i] - plan_.route[i - 1];
      const double part = std::clamp((place - plan_.route[i - 1]).dot(leg) / leg.squaredNorm(), 0.0, 1.0);
      nearest = std::min(nearest, (plan_.route[i - 1] + part * leg - place).norm());
    }
    return nearest;
  }

  const SitePlan& plan_;
  SeededRandom& random_;
  MapFrame frame_;
  cv::Mat states_;
};

struct Stop {
  double along_route_m = 0.0;
  Eigen::Vector2d place = Eigen::Vector2d::Zero();
};

/// Where along the route (its first pass) a place is nearest.
double alongRoute(const std::vector<Eigen::Vector2d>& route, const Eigen::Vector2d& place) {
  double nearest = 1e9;
  double best = 0.0;
  double before = 0.0;
  for (std::size_t i = 1; i < route.size(); ++i) {
    const Eigen::Vector2d leg = route[i] - route[i - 1];
    const double part = std::clamp((place - route[i - 1]).dot(leg) / leg.squaredNorm(), 0.0, 1.0);
    const double distance = (route[i - 1] + part * leg - place).norm();
    if (distance < nearest - 1e-9) {
      nearest = distance;
      best = before + part * leg.norm();
    }
    before += leg.norm();
  }
  return best;
}

}  // namespace

FurnishedWorld furnish(const SitePlan& plan, SeededRandom& random) {
  return Furnisher(plan, random).run();
}

std::vector<Pose2> driveThrough(const SitePlan& plan, const FurnishedWorld& world, double spacing_m,
                                SeededRandom& random) {
  std::vector<Stop> stops;
  double along = 0.0;
  for (std::size_t i = 0; i < plan.route.size(); ++i) {
    if (i > 0) along += (plan.route[i] - plan.route[i - 1]).norm();
    stops.push_back({along, plan.route[i]});
  }
  for (std::size_t i = 0; i < plan.doors.size(); ++i) {
    if (!world.door_is_open[i]) continue;
    const Doorway& door = plan.doors[i];
    const auto room = std::find_if(plan.spaces.begin(), plan.spaces.end(),
                                   [&](const Space& space) { return space.box.contains(door.inside); });
    if (room == plan.spaces.end() || room->use != SpaceUse::kRoom) continue;
    const double at = alongRoute(plan.route, door.outside);
    stops.push_back({at, door.outside});
    stops.push_back({at + 1e-3, door.inside});
    stops.push_back({at + 2e-3, room->box.center() + 0.3 * random.normal2()});
    stops.push_back({at + 3e-3, door.outside});
  }
  std::stable_sort(stops.begin(), stops.end(),
                   [](const Stop& a, const Stop& b) { return a.along_route_m < b.along_route_m; });

  PlannerSettings settings;
  settings.robot_radius_m = kRobotRadius;
  settings.wanted_clearance_m = 0.8;
  settings.step_m = spacing_m;
  std::vector<Pose2> drive;
  Eigen::Vector2d at = plan.route.front();
  for (const Stop& stop : stops) {
    const Result<PlannedPath> path = planPath(world.grid, at, stop.place, settings);
    if (!path) continue;  // furniture is in the way: the robot goes on to its next stop
    drive.insert(drive.end(), path->poses.begin(), path->poses.end());
    at = stop.place;
  }
  return drive;
}

}  // namespace cad2slam::samples
