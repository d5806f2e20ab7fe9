// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/evaluation/line_chart.h"

#include "cad2slam/evaluation/html_report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

namespace cad2slam {
namespace {

constexpr double kWidth = 720.0;
constexpr double kHeight = 380.0;
constexpr double kLeft = 64.0;
constexpr double kRight = 540.0;  // labels of the lines stand right of it
constexpr double kTop = 16.0;
constexpr double kBottom = 330.0;
constexpr double kLabelHeight = 17.0;

std::string number(double value, const char* format = "%.1f") {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), format, value);
  return text.data();
}

bool isDrawable(const Eigen::Vector2d& point) {
  return point.allFinite() && point.minCoeff() > 0.0;
}

/// Logarithmic scale of one axis.
struct Axis {
  double low = std::numeric_limits<double>::infinity();
  double high = 0.0;
  double from = 0.0;
  double to = 1.0;

  void include(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  void widen(double factor) {
    low /= factor;
    high *= factor;
  }
  [[nodiscard]] double place(double value) const {
    return from + (to - from) * std::log(value / low) / std::log(high / low);
  }
};

/// 1, 2, 5 times powers of ten within an axis.
std::vector<double> ticks(const Axis& axis) {
  std::vector<double> values;
  for (double power = std::pow(10.0, std::floor(std::log10(axis.low))); power <= axis.high; power *= 10.0) {
    for (const double digit : {1.0, 2.0, 5.0}) {
      if (digit * power >= axis.low && digit * power <= axis.high) values.push_back(digit * power);
    }
  }
  return values;
}

std::string text(double x, double y, const std::string& anchor, const std::string& words,
                 const std::string& style = "") {
  return "<text x=\"" + number(x) + "\" y=\"" + number(y) + "\" text-anchor=\"" + anchor + "\" " + style + ">" +
         escapeHtml(words) + "</text>\n";
}

std::string line(double x1, double y1, double x2, double y2) {
  return "<line x1=\"" + number(x1) + "\" y1=\"" + number(y1) + "\" x2=\"" + number(x2) + "\" y2=\"" + number(y2) +
         "\" stroke=\"currentColor\" stroke-opacity=\".15\"/>\n";
}

struct EndLabel {
  double y;
  const ChartSeries* series;
};

/// Moves labels apart so that none covers another.
void spread(std::vector<EndLabel>& labels) {
  std::sort(labels.begin(), labels.end(), [](const EndLabel& a, const EndLabel& b) { return a.y < b.y; });
  for (std::size_t i = 1; i < labels.size(); ++i) labels[i].y = std::max(labels[i].y, labels[i - 1].y + kLabelHeight);
  for (std::size_t i = labels.size(); i > 0; --i) {
    const double limit = i == labels.size() ? kBottom : labels[i].y - kLabelHeight;
    labels[i - 1].y = std::min(labels[i - 1].y, limit);
  }
}

}  // namespace

std::string drawLineChart(const std::vector<ChartSeries>& series, const std::string& x_label,
                          const std::string& y_label) {
  Axis x;
  Axis y;
  x.from = kLeft;
  x.to = kRight;
  y.from = kBottom;
  y.to = kTop;
  std::vector<double> abscissae;
  for (const ChartSeries& one : series) {
    for (const Eigen::Vector2d& point : one.points) {
      if (!isDrawable(point)) continue;
      x.include(point.x());
      y.include(point.y());
      abscissae.push_back(point.x());
    }
  }
  std::string svg = "<svg viewBox=\"0 0 " + number(kWidth) + " " + number(kHeight) +
                    "\" role=\"img\" font-family=\"system-ui, sans-serif\" "
                    "font-size=\"13\" fill=\"currentColor\">\n";
  if (abscissae.empty()) return svg + text(kWidth / 2, kHeight / 2, "middle", "nothing to show") + "</svg>\n";
  x.widen(1.08);
  y.widen(1.15);
  for (const double tick : ticks(y)) {
    svg += line(kLeft, y.place(tick), kRight, y.place(tick));
    svg += text(kLeft - 8, y.place(tick) + 4, "end", number(tick, "%g"));
  }
  std::sort(abscissae.begin(), abscissae.end());
  abscissae.erase(std::unique(abscissae.begin(), abscissae.end()), abscissae.end());
  for (const double tick : abscissae) {  // few and meaningful: the numbers that were tried
    svg += line(x.place(tick), kTop, x.place(tick), kBottom);
    svg += text(x.place(tick), kBottom + 20, "middle", number(tick, "%g"));
  }
  svg += text(0.5 * (kLeft + kRight), kHeight - 8, "middle", x_label);
  svg +=
      text(0, 0, "middle", y_label, "transform=\"translate(16 " + number(0.5 * (kTop + kBottom)) + ") rotate(-90)\"");

  std::vector<EndLabel> labels;
  for (const ChartSeries& one : series) {
    std::string path;
    double last = 0.0;
    std::string dots;
    for (const Eigen::Vector2d& point : one.points) {
      if (!isDrawable(point)) continue;
      last = y.place(point.y());
      path += path.empty() ? 'M' : 'L';
      path += number(x.place(point.x()));
      path += ' ';
      path += number(last);
      dots += "<circle cx=\"" + number(x.place(point.x())) + "\" cy=\"" + number(last) + "\" r=\"3\" fill=\"" +
              one.color + "\"/>";
    }
    if (path.empty()) continue;
    svg += "<path d=\"" + path + "\" fill=\"none\" stroke=\"" + one.color + "\" stroke-width=\"" +
           (one.emphasised ? "3.5" : "1.8") + "\"/>" + dots + "\n";
    labels.push_back({last + 4.0, &one});
  }
  spread(labels);
  for (const EndLabel& label : labels) {
    svg += text(kRight + 10, label.y, "start", label.series->label,
                "fill=\"" + label.series->color + "\"" + (label.series->emphasised ? " font-weight=\"700\"" : ""));
  }
  return svg + "</svg>\n";
}

}  // namespace cad2slam
