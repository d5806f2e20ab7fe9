// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/map/map_frame.h"

namespace cad2slam {

Result<MapFrame> MapFrame::create(double resolution_m_per_px, int width_px, int height_px,
                                  const Pose2& metric_from_corner) {
  if (!(std::isfinite(resolution_m_per_px) && resolution_m_per_px > 0.0)) {
    return fail(ErrorCode::kMalformed, "the resolution of a map must be a positive number of metres per pixel");
  }
  if (width_px <= 0 || height_px <= 0) {
    return fail(ErrorCode::kMalformed, "a map must be at least one pixel wide and high");
  }
  if (!metric_from_corner.isFinite()) {
    return fail(ErrorCode::kMalformed, "the origin of a map must be three finite numbers");
  }
  return MapFrame(resolution_m_per_px, width_px, height_px, metric_from_corner);
}

}  // namespace cad2slam
