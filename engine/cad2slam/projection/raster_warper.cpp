// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/projection/raster_warper.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <opencv2/core/utility.hpp>
#include <opencv2/imgproc.hpp>
#include <string>
#include <vector>

namespace cad2slam {
namespace {

using Eigen::Vector2d;

constexpr int kBlock_px = 16;
constexpr int kBand_px = 128;  // rows that are mapped and drawn at once: bounds the memory of the look-up
constexpr double kLargestError_px = 0.25;
constexpr float kNowhere = -1e6F;  // far outside any source, so cv::remap takes the outside value

/// Where a pixel of the target comes from.
struct SourcePixel {
  Vector2d pixel = Vector2d::Zero();
  bool drawn = false;
};

class WarpLookUp {
 public:
  WarpLookUp(const Projector& projector, WarpDirection direction, const MapFrame& source, const MapFrame& target,
             double reach_m)
      : projector_(projector), direction_(direction), source_(source), target_(target), reach_m_(reach_m) {
    if (direction_ == WarpDirection::kToSlam) markReachableBlocks();
  }

  /// Fills the rows [first_row, first_row + map.rows) of a CV_32FC2 look-up for cv::remap.
  void fill(int first_row, cv::Mat& map) const {
    for (int row = 0; row < map.rows; row += kBlock_px) {
      for (int column = 0; column < map.cols; column += kBlock_px) {
        const cv::Rect block(column, row, std::min(kBlock_px, map.cols - column), std::min(kBlock_px, map.rows - row));
        if (!isReachable(column / kBlock_px, (first_row + row) / kBlock_px)) {
          map(block).setTo(cv::Scalar::all(kNowhere));
          continue;
        }
        fillBlock(first_row, block, map);
      }
    }
  }

 private:
  /// (column, row) is a continuous pixel of the target.
  [[nodiscard]] SourcePixel lookUp(double column, double row) const {
    const Pose2 place{target_.metricFromPixel({column, row}), 0.0};
    Projection there;
    double beyond_m = 0.0;
    if (direction_ == WarpDirection::kToBlueprint) {
      beyond_m = projector_.distanceToMesh(place.translation);
      if (beyond_m <= reach_m_) there = projector_.slamFromBlueprint(place, OutsidePolicy::kRigid);
    } else {
      there = projector_.blueprintFromSlam(place, OutsidePolicy::kRigid);
      if (there.status == ProjectionStatus::kExtrapolated) {
        beyond_m = projector_.distanceToMesh(there.pose.translation);
      }
    }
    if (!there.ok() || beyond_m > reach_m_) return {};
    return {source_.pixelFromMetric(there.pose.translation), true};
  }

  static void write(cv::Vec2f& entry, const SourcePixel& from) {
    entry = from.drawn ? cv::Vec2f(static_cast<float>(from.pixel.x() - 0.5), static_cast<float>(from.pixel.y() - 0.5))
                       : cv::Vec2f(kNowhere, kNowhere);
  }

  /// Interpolates between the corners of a block where that is exact enough, and halves the block where it is not.
  void fillBlock(int first_row, const cv::Rect& block, cv::Mat& map) const {
    const double left = block.x + 0.5;
    const double top = first_row + block.y + 0.5;
    if (block.width <= 2 || block.height <= 2) {
      for (int row = 0; row < block.height; ++row) {
        for (int column = 0; column < block.width; ++column) {
          write(map.at<cv::Vec2f>(block.y + row, block.x + column), lookUp(left + column, top + row));
        }
      }
      return;
    }
    const double width = block.width - 1;
    const double height = block.height - 1;
    const SourcePixel corners[4] = {lookUp(left, top), lookUp(left + width, top), lookUp(left, top + height),
                                    lookUp(left + width, top + height)};
    const SourcePixel middle = lookUp(left + 0.5 * width, top + 0.5 * height);
    const bool all = std::all_of(std::begin(corners), std::end(corners), [](const SourcePixel& c) { return c.drawn; });
    const bool none =
        std::none_of(std::begin(corners), std::end(corners), [](const SourcePixel& c) { return c.drawn; });
    if (none && !middle.drawn) {
      map(block).setTo(cv::Scalar::all(kNowhere));
      return;
    }
    const Vector2d mean = 0.25 * (corners[0].pixel + corners[1].pixel + corners[2].pixel + corners[3].pixel);
    if (all && middle.drawn && (mean - middle.pixel).cwiseAbs().maxCoeff() < kLargestError_px) {
      interpolate(block, corners, map);
      return;
    }
    const int half_width = (block.width + 1) / 2;
    const int half_height = (block.height + 1) / 2;
    for (const int y : {0, half_height}) {
      for (const int x : {0, half_width}) {
        fillBlock(first_row,
                  {block.x + x, block.y + y, x == 0 ? half_width : block.width - half_width,
                   y == 0 ? half_height : block.height - half_height},
                  map);
      }
    }
  }

  static void interpolate(const cv::Rect& block, const SourcePixel (&corners)[4], cv::Mat& map) {
    for (int row = 0; row < block.height; ++row) {
      const double down = static_cast<double>(row) / (block.height - 1);
      const Vector2d first = (1.0 - down) * corners[0].pixel + down * corners[2].pixel;
      const Vector2d last = (1.0 - down) * corners[1].pixel + down * corners[3].pixel;
      const Vector2d step = (last - first) / (block.width - 1);
      cv::Vec2f* entries = map.ptr<cv::Vec2f>(block.y + row) + block.x;
      for (int column = 0; column < block.width; ++column) {
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
      const double stretch = projector_.jacobian(middle).norm();
      const double radius_px = (0.75 * cell_m + reach_m_) * stretch / target_.resolution();
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
