// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/exports/zone_mask.h"

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "cad2slam/map/grid_traversal.h"

namespace cad2slam {
namespace {

using Eigen::Vector2d;

constexpr std::uint8_t kTouched = 255;
constexpr std::uint8_t kFreeGrey = 254;

/// Where a ring that crosses itself counts as inside.
enum class Winding {
  kAny,  ///< wherever it goes around at all
  kOdd,  ///< where it goes around an odd number of times
};

struct Crossing {
  double x;
  int direction;
};

/// Draws into a raster that is larger than the frame by a margin, so that what lies just outside still buffers inside.
class ZoneDrawing {
 public:
  ZoneDrawing(const MapFrame& frame, int margin_px)
      : frame_(frame),
        margin_(margin_px),
        touched_(frame.height() + 2 * margin_px, frame.width() + 2 * margin_px, CV_8UC1, cv::Scalar(0)) {}

  void drawLines(const std::vector<PointList>& lines, bool closed) {
    for (const PointList& line : lines) {
      for (std::size_t k = closed ? 0 : 1; k < line.size(); ++k) {
        drawSegment(pixelOf(line[k == 0 ? line.size() - 1 : k - 1]), pixelOf(line[k]));
      }
    }
  }

  /// Sets every pixel whose middle a ring goes around. Pixels that a border meets are drawn by drawLines(), all others
  /// are wholly inside or outside: their middle says which.
  void fill(const PointList& ring_m, Winding winding, std::uint8_t value) {
    PointList ring;
    for (const Vector2d& place : ring_m) ring.push_back(pixelOf(place));
    std::vector<Crossing> crossings;
    for (int row = 0; row < touched_.rows; ++row) {
      crossings.clear();
      for (std::size_t k = 0; k < ring.size(); ++k) {
        const Vector2d& a = ring[k];
        const Vector2d& b = ring[(k + 1) % ring.size()];
        const double y = row + 0.5;
        if ((a.y() <= y) == (b.y() <= y)) continue;
        crossings.push_back({a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x()), a.y() < b.y() ? 1 : -1});
      }
      std::sort(crossings.begin(), crossings.end(), [](const Crossing& a, const Crossing& b) { return a.x < b.x; });
      int turns = 0;
      for (std::size_t k = 0; k + 1 < crossings.size(); ++k) {
        turns += crossings[k].direction;
        const bool inside = winding == Winding::kOdd ? k % 2 == 0 : turns != 0;
        if (inside) fillSpan(row, crossings[k].x, crossings[k + 1].x, value);
      }
    }
  }

  /// What lies up to `distance_px` from the middle of a drawn pixel, measured to the middle of each pixel; without the
  /// margin.
  [[nodiscard]] cv::Mat within(double distance_px) const {
    const cv::Rect inner(margin_, margin_, frame_.width(), frame_.height());
    if (distance_px < 0.0 || cv::countNonZero(touched_) == 0) {
      return cv::Mat(inner.size(), CV_8UC1, cv::Scalar(0));
    }
    if (distance_px == 0.0) return touched_(inner).clone();
    cv::Mat distance;
    cv::distanceTransform(kTouched - touched_, distance, cv::DIST_L2, cv::DIST_MASK_PRECISE);
    cv::Mat near = distance <= distance_px;
    return near(inner).clone();
  }

 private:
  [[nodiscard]] Vector2d pixelOf(const Vector2d& place_m) const {
    return frame_.pixelFromMetric(place_m) + Vector2d(margin_, margin_);
  }

  /// Every pixel whose closed square the segment meets.
  void drawSegment(Vector2d from, Vector2d to) {
    if (!clip(from, to)) return;
    touchAround(from);
    touchAround(to);
    GridTraversal ray(from, to - from);
    const auto touch = [this](int column, int row) {
      if (column >= 0 && row >= 0 && column < touched_.cols && row < touched_.rows) {
        touched_.at<std::uint8_t>(row, column) = kTouched;
      }
    };
    // A segment that runs along the border of pixels touches both sides: a hair's breadth beside it is drawn as well.
    while (ray.entered() <= 1.0) {
      touch(ray.column(), ray.row());
      const double end = std::min(ray.leaves(), 1.0);
      touchAround(from + ray.entered() * (to - from));
      touchAround(from + 0.5 * (ray.entered() + end) * (to - from));
      ray.advance();
    }
  }

  void touchAround(const Vector2d& place) {
    constexpr double kHair_px = 1e-9;
    for (const double dy : {-kHair_px, kHair_px}) {
      for (const double dx : {-kHair_px, kHair_px}) {
        const double column = std::floor(place.x() + dx);
        const double row = std::floor(place.y() + dy);
        if (column < 0 || row < 0 || column >= touched_.cols || row >= touched_.rows) continue;
        touched_.at<std::uint8_t>(static_cast<int>(row), static_cast<int>(column)) = kTouched;
      }
    }
  }

  /// Shortens a segment to the raster and a pixel around it; false when nothing is left (Liang and Barsky).
  [[nodiscard]] bool clip(Vector2d& from, Vector2d& to) const {
    const Vector2d low(-1.0, -1.0);
    const Vector2d high(touched_.cols + 1.0, touched_.rows + 1.0);
    const Vector2d along = to - from;
    double first = 0.0;
    double last = 1.0;
    for (int axis = 0; axis < 2; ++axis) {
      if (along[axis] == 0.0) {
        if (from[axis] < low[axis] || from[axis] > high[axis]) return false;
        continue;
      }
      double enter = (low[axis] - from[axis]) / along[axis];
      double leave = (high[axis] - from[axis]) / along[axis];
      if (enter > leave) std::swap(enter, leave);
      first = std::max(first, enter);
      last = std::min(last, leave);
    }
    if (first > last) return false;
    to = from + last * along;
    from += first * along;
    return true;
  }

  void fillSpan(int row, double from, double to, std::uint8_t value) {
    const double columns = touched_.cols;
    const auto first = static_cast<int>(std::clamp(std::ceil(from - 0.5), 0.0, columns));
    const auto end = static_cast<int>(std::clamp(std::floor(to - 0.5) + 1.0, 0.0, columns));
    auto* pixels = touched_.ptr<std::uint8_t>(row);
    if (first < end) std::fill(pixels + first, pixels + end, value);
  }

  const MapFrame& frame_;
  int margin_;
  cv::Mat touched_;
};

bool allFinite(const std::vector<PointList>& parts) {
  return std::all_of(parts.begin(), parts.end(), [](const PointList& part) {
    return std::all_of(part.begin(), part.end(), [](const Vector2d& place) { return place.allFinite(); });
  });
}

/// The middles of two squares with a gap g between them lie at most g + sqrt(2) apart.
const double kBothHalves_px = std::sqrt(2.0);

Result<int> marginOf(const MapFrame& frame, const MaskZone& zone) {
  constexpr double kLargestBuffer_px = 2000.0;
  const double buffer_px = zone.buffer_m / frame.resolution();
  if (!(buffer_px >= 0.0) || buffer_px > kLargestBuffer_px) {
    return fail(ErrorCode::kOutOfDomain,
                "the buffer of a zone must lie between 0 and " +
                    std::to_string(std::lround(std::floor(kLargestBuffer_px * frame.resolution()))) + " m");
  }
  if (!allFinite(zone.rings) || !allFinite(zone.lines)) {
    return fail(ErrorCode::kOutOfDomain, "a zone has a place that is not finite");
  }
  return static_cast<int>(std::ceil(buffer_px + kBothHalves_px)) + 1;
}

}  // namespace

Result<cv::Mat> touchedPixels(const MapFrame& frame, const MaskZone& zone) {
  const Result<int> margin = marginOf(frame, zone);
  if (!margin) return failAs(margin);
  ZoneDrawing drawing(frame, *margin);
  for (std::size_t k = 0; k < zone.rings.size(); ++k) {
    drawing.fill(zone.rings[k], k == 0 ? Winding::kAny : Winding::kOdd, k == 0 ? kTouched : 0);
  }
  drawing.drawLines(zone.rings, true);
  drawing.drawLines(zone.lines, false);
  return drawing.within(zone.buffer_m > 0.0 ? zone.buffer_m / frame.resolution() + kBothHalves_px : 0.0);
}

Result<cv::Mat> coveredPixels(const MapFrame& frame, const MaskZone& zone) {
  const Result<int> margin = marginOf(frame, zone);
  if (!margin) return failAs(margin);
  const double buffer_px = zone.buffer_m / frame.resolution();
  ZoneDrawing filled(frame, *margin);
  for (std::size_t k = 0; k < zone.rings.size(); ++k) {
    filled.fill(zone.rings[k], k == 0 ? Winding::kOdd : Winding::kAny, k == 0 ? kTouched : 0);
  }
  ZoneDrawing border(frame, *margin);
  border.drawLines(zone.rings, true);
  ZoneDrawing lines(frame, *margin);
  lines.drawLines(zone.lines, false);
  const cv::Mat unsure = border.within(zone.buffer_m > 0.0 ? buffer_px + kBothHalves_px : 0.0);
  return (filled.within(0.0) & ~unsure) | lines.within(buffer_px - kBothHalves_px);
}

Result<cv::Mat> keepoutMask(const MapFrame& frame, const std::vector<MaskZone>& zones, bool invert) {
  cv::Mat mask(frame.height(), frame.width(), CV_8UC1, cv::Scalar(invert ? 0 : kFreeGrey));
  for (const MaskZone& zone : zones) {
    const Result<cv::Mat> pixels = invert ? coveredPixels(frame, zone) : touchedPixels(frame, zone);
    if (!pixels) return failAs(pixels);
    mask.setTo(invert ? kFreeGrey : 0, *pixels);
  }
  return mask;
}

std::uint8_t greyOfPercent(double percent) {
  return static_cast<std::uint8_t>(255 - std::lround(std::clamp(percent, 0.0, 100.0) * 2.55));
}

Result<cv::Mat> speedMask(const MapFrame& frame, const std::vector<SpeedZone>& zones) {
  cv::Mat mask(frame.height(), frame.width(), CV_8UC1, cv::Scalar(greyOfPercent(0.0)));
  std::vector<const SpeedZone*> order;
  for (const SpeedZone& zone : zones) {
    if (!(zone.percent >= 1.0 && zone.percent <= 100.0)) {
      return fail(ErrorCode::kOutOfDomain, "the speed of a zone must be 1 to 100 percent");
    }
    order.push_back(&zone);
  }
  // The slowest is drawn last.
  std::stable_sort(order.begin(), order.end(),
                   [](const SpeedZone* a, const SpeedZone* b) { return a->percent > b->percent; });
  for (const SpeedZone* zone : order) {
    const Result<cv::Mat> touched = touchedPixels(frame, zone->zone);
    if (!touched) return failAs(touched);
    mask.setTo(greyOfPercent(zone->percent), *touched);
  }
  return mask;
}

}  // namespace cad2slam
