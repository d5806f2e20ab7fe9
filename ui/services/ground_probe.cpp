// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/services/ground_probe.h"

#include <algorithm>
#include <cmath>

namespace cad2slam {
namespace {

// Corners are clicked on the far side of a wall as well: unknown ground only counts when there is nothing else near.
constexpr double kReach_m = 0.2;
constexpr double kLeastReach_px = 3.0;
constexpr double kMostReach_px = 40.0;
constexpr std::size_t kMostKept = 20'000;

}  // namespace

GroundProbe::GroundProbe(std::shared_ptr<TileStore> store, const MapFrame& frame, const MapMetadata& metadata)
    : store_(std::move(store)), frame_(frame) {
  rules_.mode = metadata.mode;
  rules_.negate = metadata.negate;
  rules_.occupied_threshold = metadata.occupied_threshold;
  rules_.free_threshold = metadata.free_threshold;
}

bool GroundProbe::isOf(const std::shared_ptr<TileStore>& store, const MapFrame& frame) const {
  const Pose2& mine = frame_.metricFromCorner();
  const Pose2& other = frame.metricFromCorner();
  return store == store_ && frame.resolution() == frame_.resolution() && other.translation == mine.translation &&
         other.heading == mine.heading;
}

Ground GroundProbe::at(const Eigen::Vector2d& point_m) {
  if (!point_m.allFinite()) return Ground::kOutsideImage;
  const Eigen::Vector2d pixel = frame_.pixelFromMetric(point_m);
  // A corner of the plan may lie on the very edge of its image.
  if (pixel.minCoeff() < -1.0 || pixel.x() > frame_.width() + 1.0 || pixel.y() > frame_.height() + 1.0)
    return Ground::kOutsideImage;
  if (store_->hadTransparency()) return Ground::kKnown;  // map_server takes it for unknown, the picture shows white
  const auto before = known_.find({point_m.x(), point_m.y()});
  if (before != known_.end()) return before->second;

  const int reach =
      static_cast<int>(std::lround(std::clamp(kReach_m / frame_.resolution(), kLeastReach_px, kMostReach_px)));
  const cv::Rect around(static_cast<int>(pixel.x()) - reach, static_cast<int>(pixel.y()) - reach, 2 * reach + 1,
                        2 * reach + 1);
  bool complete = false;
  const cv::Mat picture = store_->region(0, around, 0, &complete);
  if (!complete || picture.empty()) return Ground::kKnown;
  const Result<std::unique_ptr<PixelClassifier>> classifier = PixelClassifier::create(picture.type(), rules_);
  if (!classifier) return Ground::kKnown;
  const cv::Mat states = (*classifier)->classify(picture);
  const bool nothing = std::all_of(states.begin<uchar>(), states.end<uchar>(),
                                   [](uchar state) { return static_cast<CellState>(state) == CellState::kUnknown; });
  if (known_.size() >= kMostKept) known_.clear();
  return known_[{point_m.x(), point_m.y()}] = nothing ? Ground::kUnknown : Ground::kKnown;
}

}  // namespace cad2slam
