// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/evaluation/report_pictures.h"

#include "cad2slam/projection/overlay_picture.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace cad2slam {
namespace {

constexpr int kLegendHeight = 44;
constexpr double kShown = 0.99;  // quantile at which the colours end

class ColorScale {
 public:
  explicit ColorScale(std::vector<double> values) {
    values.erase(std::remove_if(values.begin(), values.end(), [](double value) { return !std::isfinite(value); }),
                 values.end());
    if (!values.empty()) {
      const auto at = static_cast<std::ptrdiff_t>(kShown * static_cast<double>(values.size() - 1));
      std::nth_element(values.begin(), values.begin() + at, values.end());
      top_ = std::max(values[static_cast<std::size_t>(at)], 1e-9);
    }
    cv::Mat ramp(1, 256, CV_8UC1);
    for (int i = 0; i < 256; ++i) ramp.at<std::uint8_t>(i) = static_cast<std::uint8_t>(i);
    cv::applyColorMap(ramp, colors_, cv::COLORMAP_VIRIDIS);
  }

  [[nodiscard]] cv::Scalar operator()(double value) const {
    const double part = std::isfinite(value) ? std::clamp(value / top_, 0.0, 1.0) : 1.0;
    const cv::Vec3b color = colors_.at<cv::Vec3b>(static_cast<int>(std::lround(255.0 * part)));
    return {static_cast<double>(color[0]), static_cast<double>(color[1]), static_cast<double>(color[2])};
  }
  [[nodiscard]] double top() const { return top_; }

  void drawLegend(cv::Mat& picture, const std::string& unit) const {
    const int top = picture.rows - kLegendHeight;
    const int width = std::min(420, picture.cols - 40);
    for (int i = 0; i < width; ++i) {
      cv::line(picture, {20 + i, top + 8}, {20 + i, top + 20}, (*this)(top_ * i / std::max(1, width - 1)));
    }
    for (const double part : {0.0, 0.5, 1.0}) {
      std::array<char, 64> text{};
      std::snprintf(text.data(), text.size(), part == 1.0 ? "%.3g %s" : "%.3g", part * top_, unit.c_str());
      cv::putText(picture, text.data(), {20 + static_cast<int>(part * width) - (part > 0.0 ? 14 : 0), top + 37},
                  cv::FONT_HERSHEY_SIMPLEX, 0.42, cv::Scalar::all(40), 1, cv::LINE_AA);
    }
  }

 private:
  double top_ = 1.0;
  cv::Mat colors_;
};

/// A map as a pale picture with room for a legend below, and where its metres lie on it.
class Canvas {
 public:
  [[nodiscard]] static Result<Canvas> create(const OccupancyGrid& map, int largest_side_px) {
    const int side = std::max(map.frame().width(), map.frame().height());
    const int factor = std::max(1, (side + largest_side_px - 1) / std::max(1, largest_side_px));
    const Result<OccupancyGrid> small = pooled(map, factor);
    if (!small) return failAs(small);
    return Canvas(*small);
  }

  [[nodiscard]] cv::Point pixel(const Eigen::Vector2d& point_m) const {
    const Eigen::Vector2d at = frame_.pixelFromMetric(point_m);
    return {static_cast<int>(std::clamp(std::floor(at.x()), -1e6, 1e6)),
            static_cast<int>(std::clamp(std::floor(at.y()), -1e6, 1e6))};
  }
  [[nodiscard]] double resolution() const { return frame_.resolution(); }
  [[nodiscard]] cv::Mat& picture() { return picture_; }
  void drawWalls() {
    picture_(cv::Rect({0, 0}, states_.size()))
        .setTo(cv::Scalar::all(60), states_ == static_cast<int>(CellState::kOccupied));
  }

 private:
  explicit Canvas(const OccupancyGrid& map) : frame_(map.frame()), states_(map.states()) {
    picture_ = cv::Mat(states_.rows + kLegendHeight, states_.cols, CV_8UC3, cv::Scalar::all(255));
    picture_(cv::Rect({0, 0}, states_.size()))
        .setTo(cv::Scalar::all(225), states_ == static_cast<int>(CellState::kUnknown));
  }

  MapFrame frame_;
  cv::Mat states_;
  cv::Mat picture_;
};

}  // namespace

Result<cv::Mat> drawValueMap(const OccupancyGrid& map, const std::vector<PlacedValue>& values, double size_m,
                             const std::string& unit, int largest_side_px) {
  Result<Canvas> canvas = Canvas::create(map, largest_side_px);
  if (!canvas) return failAs(canvas);
  std::vector<double> numbers;
  for (const PlacedValue& value : values) numbers.push_back(value.value);
  const ColorScale colors(std::move(numbers));
  const int half = std::max(1, static_cast<int>(std::ceil(0.5 * size_m / canvas->resolution())));
  for (const PlacedValue& value : values) {
    const cv::Point center = canvas->pixel(value.place);
    cv::rectangle(canvas->picture(), center - cv::Point(half, half), center + cv::Point(half, half),
                  colors(value.value), cv::FILLED);
  }
  canvas->drawWalls();
  colors.drawLegend(canvas->picture(), unit);
  return canvas->picture();
}

Result<cv::Mat> drawWays(const OccupancyGrid& map, const std::vector<std::vector<PlacedValue>>& ways,
                         const std::string& unit, int largest_side_px) {
  Result<Canvas> canvas = Canvas::create(map, largest_side_px);
  if (!canvas) return failAs(canvas);
  canvas->drawWalls();
  std::vector<double> numbers;
  for (const auto& way : ways) {
    for (const PlacedValue& value : way) numbers.push_back(value.value);
  }
  const ColorScale colors(std::move(numbers));
  const int thickness = std::max(2, canvas->picture().cols / 300);
  for (const auto& way : ways) {
    for (std::size_t i = 1; i < way.size(); ++i) {
      cv::line(canvas->picture(), canvas->pixel(way[i - 1].place), canvas->pixel(way[i].place), colors(way[i].value),
               thickness, cv::LINE_AA);
    }
    if (way.empty()) continue;
    cv::circle(canvas->picture(), canvas->pixel(way.front().place), 2 * thickness, cv::Scalar(40, 40, 40), 2,
               cv::LINE_AA);
    cv::circle(canvas->picture(), canvas->pixel(way.back().place), 2 * thickness, cv::Scalar(40, 40, 200), cv::FILLED,
               cv::LINE_AA);
  }
  colors.drawLegend(canvas->picture(), unit);
  return canvas->picture();
}

}  // namespace cad2slam
