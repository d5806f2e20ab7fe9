// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>

#include <vector>

#include "cad2slam/core/result.h"
#include "cad2slam/map/map_frame.h"
#include "cad2slam/simulation/seeded_random.h"
#include "cad2slam/simulation/warp_field.h"
#include "furnished_world.h"

namespace cad2slam::samples {

/// What SLAM saves: 0 occupied, 254 free, 205 unknown.
struct SlamMap {
  MapFrame frame;
  cv::Mat picture;
};

struct SensorModel {
  double range_max_m = 14.0;
  int beams = 720;
  double noise_m = 0.015;
  double dropout = 0.01;  ///< beams that do not come back
  int people = 4;         ///< who walk around while the map is made
};

/// Maps a drive by log-odds. Every beam is cast in the real building and entered where the warp puts it.
[[nodiscard]] Result<SlamMap> mapDrive(const SitePlan& plan, const FurnishedWorld& world,
                                       const std::vector<Pose2>& drive, const WarpField& warp,
                                       const SensorModel& sensor, double resolution_m_per_px, SeededRandom& random);

}  // namespace cad2slam::samples
