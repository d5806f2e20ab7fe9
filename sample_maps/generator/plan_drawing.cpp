// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "plan_drawing.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace cad2slam::samples {
namespace {

constexpr int kWhite = 255;
constexpr int kBlack = 0;
constexpr int kOutside = 205;
constexpr int kLightInk = 216;  // occupancy 0.153: free with map_server's default threshold of 0.196
constexpr int kInk = 140;       // occupancy 0.451: neither free nor occupied

class Drawing {
 public:
  explicit Drawing(const Building& building) : building_(building), frame_(building.blueprint.frame()) {
    px_per_m_ = building.blueprint_from_plan.scale / frame_.resolution();
  }

  cv::Mat run(const std::string& title) {
    const cv::Mat states = building_.blueprint.states();
    const cv::Mat is_free = states == static_cast<int>(CellState::kFree);
    const cv::Mat is_wall = states == static_cast<int>(CellState::kOccupied);
    cv::Mat inside(states.size(), CV_8UC1, cv::Scalar(kWhite));
    for (const Doorway& door : building_.plan.doors) drawDoor(inside, door);
    numberRooms(inside);
    picture_ = cv::Mat(states.size(), CV_8UC1, cv::Scalar(kOutside));
    dimension();
    text(picture_, title, {0.0, -1.05}, 0.42, kInk, false);
    inside.copyTo(picture_, is_free);
    picture_.setTo(kBlack, is_wall);
    return picture_;
  }

 private:
  [[nodiscard]] cv::Point pixel(const Eigen::Vector2d& point_in_plan) const {
    const Eigen::Vector2d at = frame_.pixelFromMetric(building_.blueprint_from_plan * point_in_plan);
    return {static_cast<int>(std::lround(at.x() - 0.5)), static_cast<int>(std::lround(at.y() - 0.5))};
  }

  void text(cv::Mat& image, const std::string& words, const Eigen::Vector2d& at, double height_m, int ink,
            bool centered) const {
    const double scale = height_m * px_per_m_ / 22.0;  // this font is 22 px high at scale 1
    const int thickness = std::max(1, static_cast<int>(std::lround(1.6 * scale)));
    cv::Point place = pixel(at);
    if (centered) {
      const cv::Size size = cv::getTextSize(words, cv::FONT_HERSHEY_SIMPLEX, scale, thickness, nullptr);
      place += cv::Point(-size.width / 2, size.height / 2);
    }
    cv::putText(image, words, place, cv::FONT_HERSHEY_SIMPLEX, scale, cv::Scalar(ink), thickness, cv::LINE_8);
  }

  void drawDoor(cv::Mat& image, const Doorway& door) const {
    const int along = door.wall_along_x ? 0 : 1;
    const double width = door.opening.size()[along];
    const bool is_double = width > 1.2;
    const double leaf = is_double ? 0.5 * width : width;
    const Eigen::Vector2d inward = (door.inside - door.outside).normalized();
    const Eigen::Vector2d unit = Eigen::Vector2d::Unit(along);
    for (const double side : {-1.0, 1.0}) {
      if (!is_double && side > 0.0) break;
      const Eigen::Vector2d hinge =
          door.opening.center() + side * 0.5 * width * unit + 0.5 * door.opening.size()[1 - along] * inward;
      cv::line(image, pixel(hinge), pixel(hinge + leaf * inward), cv::Scalar(kLightInk));
      cv::Point before = pixel(hinge - side * leaf * unit);
      for (int step = 1; step <= 16; ++step) {
        const double turn = 0.5 * kPi * step / 16.0;
        const cv::Point next = pixel(hinge + leaf * (-side * std::cos(turn) * unit + std::sin(turn) * inward));
        cv::line(image, before, next, cv::Scalar(kLightInk));
        before = next;
      }
    }
  }

  void numberRooms(cv::Mat& image) const {
    int number = 101;
    for (const Space& space : building_.plan.spaces) {
      if (space.use == SpaceUse::kRoom) {
        std::array<char, 40> area{};
        const double claimed_scale = building_.blueprint_from_plan.scale;  // the drawing believes itself
        std::snprintf(area.data(), area.size(), "%.1f m2", space.box.size().prod() * claimed_scale * claimed_scale);
        text(image, std::to_string(number++), space.box.center() + Eigen::Vector2d(0.0, 0.25), 0.38, kLightInk, true);
        if (space.box.size().minCoeff() > 2.6) {
          text(image, area.data(), space.box.center() - Eigen::Vector2d(0.0, 0.35), 0.26, kLightInk, true);
        }
      }
    }
  }

  /// The overall length above the building.
  void dimension() {
    const Eigen::Vector2d& size = building_.plan.size_m;
    const double y = size.y() + building_.plan.outer_wall_m + 0.55;
    const double wall = building_.plan.outer_wall_m;
    const Eigen::Vector2d left(-wall, y);
    const Eigen::Vector2d right(size.x() + wall, y);
    cv::line(picture_, pixel(left), pixel(right), cv::Scalar(kInk));
    for (const Eigen::Vector2d& end : {left, right}) {
      const Eigen::Vector2d tick(0.15, 0.15);
      cv::line(picture_, pixel(end - tick), pixel(end + tick), cv::Scalar(kInk));
    }
    std::array<char, 40> length{};
    std::snprintf(length.data(), length.size(), "%.2f", (right - left).norm() * building_.blueprint_from_plan.scale);
    text(picture_, length.data(), 0.5 * (left + right) + Eigen::Vector2d(0.0, 0.35), 0.36, kInk, true);
  }

  const Building& building_;
  const MapFrame& frame_;
  double px_per_m_ = 20.0;
  cv::Mat picture_;
};

}  // namespace

cv::Mat drawBlueprint(const Building& building, const std::string& title) {
  return Drawing(building).run(title);
}

}  // namespace cad2slam::samples
