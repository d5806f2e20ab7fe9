// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/services/blueprint_map.h"

#include "cad2slam/io/map_file.h"
#include "cad2slam/projection/overlay_picture.h"

namespace cad2slam {

Result<void> writeBlueprintMap(const std::filesystem::path& yaml, const Projector& projector,
                               const OccupancyGrid& blueprint, const MapFrame& slam_frame,
                               const std::function<bool()>& is_stopped) {
  const Result<OccupancyGrid> warped = warpGrid(projector, true, blueprint, slam_frame);
  if (!warped) return failAs(warped);
  const cv::Mat picture = trinaryPicture(*warped);
  if (is_stopped()) return fail(ErrorCode::kCancelled, "Drawing the map was cancelled, it is not written");
  MapMetadata metadata;  // its thresholds are those of map_server, which keep 205 unknown
  metadata.resolution_m_per_px = slam_frame.resolution();
  metadata.metric_from_corner = slam_frame.metricFromCorner();
  return writeMap(yaml, imageOfBlueprintMap(yaml).filename().string(), picture, metadata);
}

std::filesystem::path imageOfBlueprintMap(const std::filesystem::path& yaml) {
  return std::filesystem::path(yaml).replace_extension(".png");
}

}  // namespace cad2slam
