// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include <map>
#include <memory>
#include <utility>

#include "cad2slam/io/map_file.h"
#include "cad2slam/io/pixel_classifier.h"
#include "cad2slam/map/map_frame.h"
#include "ui/document/diagnosis.h"
#include "ui/services/tile_store.h"

namespace cad2slam {

/// What a map shows around places of it, read from its picture as map_server reads it. For one worker at a time, which
/// asks for the same places after every edit: answers are kept.
class GroundProbe {
 public:
  /// `frame`: of the picture in `store`.
  GroundProbe(std::shared_ptr<TileStore> store, const MapFrame& frame, const MapMetadata& metadata);

  [[nodiscard]] bool isOf(const std::shared_ptr<TileStore>& store, const MapFrame& frame) const;

  /// Ground::kKnown too as long as the picture is not read that far.
  [[nodiscard]] Ground at(const Eigen::Vector2d& point_m);

 private:
  std::shared_ptr<TileStore> store_;
  MapFrame frame_;
  PixelRules rules_;
  std::map<std::pair<double, double>, Ground> known_;
};

}  // namespace cad2slam
