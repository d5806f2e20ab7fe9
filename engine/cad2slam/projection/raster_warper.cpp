// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/projection/raster_warper.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <opencv2/core/utility.hpp>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace cad2slam {
namespace {

using Eigen::Vector2d;

constexpr int kBlock_px = 16;
constexpr int kBand_px = 128;  // rows that are mapped and drawn at once: bounds the memory of the look-up
constexpr int kSmallestBeyond_px = 4;
constexpr double kLargestError_px = 0.25;
constexpr float kNowhere = -1e6F;  // far outside any source, so cv::remap takes the outside value

/// Where a pixel of the target comes from.
struct SourcePixel {
  Vector2d pixel = Vector2d::Zero();
  Vector2d metric = Vector2d::Zero();
  bool drawn = false;
  bool beyond = false;  ///< the mesh, as walls are
};

/// Largest singular value.
double largestStretch(const Eigen::Matrix2d& a) {
  return 0.5 * (std::hypot(a(0, 0) + a(1, 1), a(1, 0) - a(0, 1)) + std::hypot(a(0, 0) - a(1, 1), a(1, 0) + a(0, 1)));
}

class WarpLookUp {
 public:
  WarpLookUp(const Projector& projector, WarpDirection direction, const MapFrame& source, const MapFrame& target,
             double reach_m)
      : projector_(projector), direction_(direction), source_(source), target_(target), reach_m_(reach_m) {
    if (direction_ == WarpDirection::kToSlam) markReachableBlocks();
  }

  /// Fills the rows [first_row, first_row + map.rows) of a CV_32FC2 look-up for cv::remap.
  void fill(int first_row, cv::Mat& map) const {
    const auto columns = static_cast<std::size_t>((map.cols + kBlock_px - 1) / kBlock_px);
    CornerRow above(columns + 1);
    CornerRow below(columns + 1);
    for (int row = 0; row < map.rows; row += kBlock_px) {
      for (std::size_t column = 0; column < columns; ++column) {
        const int x = static_cast<int>(column) * kBlock_px;
        if (!isReachable(x / kBlock_px, (first_row + row) / kBlock_px)) {
          map(cv::Rect(x, row, kBlock_px, kBlock_px) & cv::Rect({}, map.size())).setTo(cv::Scalar::all(kNowhere));
          continue;
        }
        const SourcePixel start = column > 0 && above[column - 1] ? *above[column - 1] : SourcePixel();
        const int y = first_row + row;
        const Corners corners = {corner(above[column], x, y, start), corner(above[column + 1], x + kBlock_px, y, start),
                                 corner(below[column], x, y + kBlock_px, start),
                                 corner(below[column + 1], x + kBlock_px, y + kBlock_px, start)};
        fillSquare({x, row, kBlock_px}, first_row, corners, map);
      }
      std::swap(above, below);
      std::fill(below.begin(), below.end(), std::nullopt);
    }
  }

 private:
  /// Where the middles of four pixels come from: upper left, upper right, lower left, lower right.
  using Corners = std::array<SourcePixel, 4>;
  /// Corners of one row of blocks, shared with the row above; empty where nobody has asked yet.
  using CornerRow = std::vector<std::optional<SourcePixel>>;

  /// A square of pixels, its upper left one in the look-up being filled.
  struct Square {
    int x = 0;
    int y = 0;
    int side = 0;
  };

  const SourcePixel& corner(std::optional<SourcePixel>& known, int x, int y, const SourcePixel& neighbour) const {
    if (!known) known = lookUp(x + 0.5, y + 0.5, neighbour);
    return *known;
  }

  /// (column, row) is a continuous pixel of the target.
  [[nodiscard]] SourcePixel lookUp(double column, double row, const SourcePixel& neighbour = {}) const {
    const Pose2 place{target_.metricFromPixel({column, row}), 0.0};
    Projection there;
    double beyond_m = 0.0;
    if (direction_ == WarpDirection::kToBlueprint) {
      beyond_m = projector_.distanceToMesh(place.translation);
      if (beyond_m <= reach_m_) there = projector_.slamFromBlueprint(place, OutsidePolicy::kRigid);
    } else {
      there = neighbour.drawn && !neighbour.beyond
                  ? projector_.blueprintFromSlam(place, OutsidePolicy::kRigid, neighbour.metric)
                  : projector_.blueprintFromSlam(place, OutsidePolicy::kRigid);
      if (there.status == ProjectionStatus::kExtrapolated) {
        beyond_m = projector_.distanceToMesh(there.pose.translation);
      }
    }
    if (!there.ok() || beyond_m > reach_m_) return {};
    return {source_.pixelFromMetric(there.pose.translation), there.pose.translation, true, beyond_m > 0.0};
  }

  static void write(cv::Vec2f& entry, const SourcePixel& from) {
    entry = from.drawn ? cv::Vec2f(static_cast<float>(from.pixel.x() - 0.5), static_cast<float>(from.pixel.y() - 0.5))
                       : cv::Vec2f(kNowhere, kNowhere);
  }

  /// Interpolates between the corners of a square where that is exact enough, and quarters it where it is not.
  void fillSquare(const Square& square, int first_row, const Corners& corners, cv::Mat& map) const {
    if (square.x >= map.cols || square.y >= map.rows) return;
    if (square.side == 1) return write(map.at<cv::Vec2f>(square.y, square.x), corners[0]);
    const double left = square.x + 0.5;
    const double top = first_row + square.y + 0.5;
    const double half = 0.5 * square.side;
    const SourcePixel middle = lookUp(left + half, top + half, corners[0]);
    if (!middle.drawn && std::none_of(corners.begin(), corners.end(), isDrawn)) {
      map(rectOf(square, map)).setTo(cv::Scalar::all(kNowhere));
      return;
    }
    if (middle.drawn && std::all_of(corners.begin(), corners.end(), isDrawn) && isExact(square, corners, middle)) {
      return interpolate(square, corners, map);
    }
    const SourcePixel up = lookUp(left + half, top, middle);
    const SourcePixel down = lookUp(left + half, top + square.side, middle);
    const SourcePixel west = lookUp(left, top + half, middle);
    const SourcePixel east = lookUp(left + square.side, top + half, middle);
    const int side = square.side / 2;
    fillSquare({square.x, square.y, side}, first_row, {corners[0], up, west, middle}, map);
    fillSquare({square.x + side, square.y, side}, first_row, {up, corners[1], middle, east}, map);
    fillSquare({square.x, square.y + side, side}, first_row, {west, middle, corners[2], down}, map);
    fillSquare({square.x + side, square.y + side, side}, first_row, {middle, east, down, corners[3]}, map);
  }

  static bool isDrawn(const SourcePixel& pixel) { return pixel.drawn; }

  /// Halfway between two rooms the continuation jumps from one to the other: not worth a look-up for each pixel.
  static bool isExact(const Square& square, const Corners& corners, const SourcePixel& middle) {
    const Vector2d mean = 0.25 * (corners[0].pixel + corners[1].pixel + corners[2].pixel + corners[3].pixel);
    const double error_px = (mean - middle.pixel).cwiseAbs().maxCoeff();
    const bool all_beyond =
        middle.beyond && std::all_of(corners.begin(), corners.end(), [](const SourcePixel& c) { return c.beyond; });
    return error_px < kLargestError_px || (all_beyond && square.side <= kSmallestBeyond_px);
  }

  static cv::Rect rectOf(const Square& square, const cv::Mat& map) {
    return cv::Rect(square.x, square.y, square.side, square.side) & cv::Rect({}, map.size());
  }

  static void interpolate(const Square& square, const Corners& corners, cv::Mat& map) {
    const cv::Rect inside = rectOf(square, map);
    for (int row = 0; row < inside.height; ++row) {
      const double down = static_cast<double>(row) / square.side;
      const Vector2d first = (1.0 - down) * corners[0].pixel + down * corners[2].pixel;
      const Vector2d last = (1.0 - down) * corners[1].pixel + down * corners[3].pixel;
      const Vector2d step = (last - first) / square.side;
      cv::Vec2f* entries = map.ptr<cv::Vec2f>(square.y + row) + square.x;
      for (int column = 0; column < inside.width; ++column) {
        const Vector2d pixel = first + column * step;
        entries[column] = {static_cast<float>(pixel.x() - 0.5), static_cast<float>(pixel.y() - 0.5)};
      }
    }
  }

  /// Most of a SLAM raster may be far from the mesh, where looking for an inverse is slow and in vain.
  void markReachableBlocks() {
    blocks_across_ = (target_.width() + kBlock_px - 1) / kBlock_px;
    blocks_down_ = (target_.height() + kBlock_px - 1) / kBlock_px;
    reachable_.assign(static_cast<std::size_t>(blocks_across_) * static_cast<std::size_t>(blocks_down_), 0);
    const double cell_m = projector_.info().lattice.cell_size;
    for (const Vector2d& middle : projector_.tileMiddles()) {
      const Projection there = projector_.slamFromBlueprint({middle, 0.0}, OutsidePolicy::kRigid);
      if (!there.ok()) continue;
      const double radius_px =
          (0.75 * cell_m + reach_m_) * largestStretch(projector_.jacobian(middle)) / target_.resolution();
      const Vector2d pixel = target_.pixelFromMetric(there.pose.translation);
      const auto blockOf = [](double px, int count) {
        return static_cast<int>(std::clamp(std::floor(px / kBlock_px), -1.0, static_cast<double>(count)));
      };
      const int left = std::max(0, blockOf(pixel.x() - radius_px, blocks_across_));
      const int right = std::min(blocks_across_ - 1, blockOf(pixel.x() + radius_px, blocks_across_));
      const int top = std::max(0, blockOf(pixel.y() - radius_px, blocks_down_));
      const int bottom = std::min(blocks_down_ - 1, blockOf(pixel.y() + radius_px, blocks_down_));
      for (int row = top; row <= bottom; ++row) {
        for (int column = left; column <= right; ++column) {
          reachable_[static_cast<std::size_t>(row * blocks_across_ + column)] = 1;
        }
      }
    }
  }

  [[nodiscard]] bool isReachable(int block_column, int block_row) const {
    return reachable_.empty() || reachable_[static_cast<std::size_t>(block_row * blocks_across_ + block_column)] != 0;
  }

  const Projector& projector_;
  WarpDirection direction_;
  const MapFrame& source_;
  const MapFrame& target_;
  double reach_m_;
  int blocks_across_ = 0;
  int blocks_down_ = 0;
  std::vector<std::uint8_t> reachable_;
};

double reachOf(const Projector& projector, const WarpOptions& options) {
  return options.reach_m >= 0.0 ? options.reach_m : 1.5 * projector.info().lattice.cell_size;
}

}  // namespace

Result<cv::Mat> warpRaster(const Projector& projector, WarpDirection direction, const cv::Mat& source,
                           const MapFrame& source_frame, const MapFrame& target_frame, const WarpOptions& options) {
  static_assert(kBand_px % kBlock_px == 0);
  if (source.cols != source_frame.width() || source.rows != source_frame.height()) {
    return fail(ErrorCode::kOutOfDomain, "the picture is not as large as its frame says");
  }
  constexpr int kLargestSide_px = 32'766;  // of cv::remap
  if (std::max({source.cols, source.rows, target_frame.width(), target_frame.height()}) > kLargestSide_px) {
    return fail(ErrorCode::kOutOfDomain, "pictures wider or higher than " + std::to_string(kLargestSide_px) +
                                             " pixels cannot be warped; choose a coarser resolution");
  }
  const WarpLookUp look_up(projector, direction, source_frame, target_frame, reachOf(projector, options));
  cv::Mat target(target_frame.height(), target_frame.width(), source.type());
  const int bands = (target.rows + kBand_px - 1) / kBand_px;
  cv::parallel_for_(cv::Range(0, bands), [&](const cv::Range& range) {
    for (int band = range.start; band < range.end; ++band) {
      const int first_row = band * kBand_px;
      const int rows = std::min(kBand_px, target.rows - first_row);
      cv::Mat map(rows, target.cols, CV_32FC2);
      look_up.fill(first_row, map);
      cv::Mat drawn = target.rowRange(first_row, first_row + rows);
      cv::remap(source, drawn, map, cv::noArray(), options.smooth ? cv::INTER_LINEAR : cv::INTER_NEAREST,
                cv::BORDER_CONSTANT, options.outside_value);
    }
  });
  return target;
}

Result<MapFrame> warpedExtent(const Projector& projector, WarpDirection direction, const MapFrame& source_frame,
                              double resolution_m_per_px) {
  if (!(resolution_m_per_px > 0.0) || !std::isfinite(resolution_m_per_px)) {
    return fail(ErrorCode::kOutOfDomain, "the resolution must be a positive number of metres per pixel");
  }
  Eigen::AlignedBox2d box;
  const double margin_m = reachOf(projector, {}) + 0.5 * projector.info().lattice.cell_size;
  for (const Vector2d& middle : projector.tileMiddles()) {
    for (const double dx : {-margin_m, margin_m}) {
      for (const double dy : {-margin_m, margin_m}) {
        const Vector2d corner = middle + Vector2d(dx, dy);
        if (!source_frame.contains(middle) && direction == WarpDirection::kToSlam) continue;
        if (direction == WarpDirection::kToBlueprint) {
          box.extend(corner);
          continue;
        }
        const Projection there = projector.slamFromBlueprint({corner, 0.0}, OutsidePolicy::kRigid);
        if (there.ok()) box.extend(there.pose.translation);
      }
    }
  }
  if (box.isEmpty()) return fail(ErrorCode::kDegenerate, "the projector draws nothing of this picture");
  const Vector2d pixels = (box.sizes() / resolution_m_per_px).array().ceil().max(1.0);
  if (pixels.maxCoeff() > 1e6) {
    return fail(ErrorCode::kOutOfDomain,
                "the warped picture would be wider than a million pixels; choose a coarser resolution");
  }
  return MapFrame::create(resolution_m_per_px, static_cast<int>(pixels.x()), static_cast<int>(pixels.y()),
                          Pose2{box.min(), 0.0});
}

}  // namespace cad2slam
