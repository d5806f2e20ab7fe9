// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "cad2slam/anchors/anchor.h"
#include "cad2slam/core/result.h"
#include "cad2slam/exports/feature.h"
#include "cad2slam/map/map_frame.h"

namespace cad2slam {

/// A place that somebody marked on a drawing of the traffic editor.
struct RmfMark {
  Eigen::Vector2d pixel = Eigen::Vector2d::Zero();  ///< column, row from the top left corner of the picture
  std::string name;
};

/// A picture laid over the drawing of a level, such as the map of a robot.
struct RmfLayer {
  std::string picture;  ///< file name
  std::map<std::string, RmfMark> marks;
};

struct RmfLevel {
  std::string picture;  ///< file name of the drawing
  std::map<std::string, RmfMark> marks;
  std::map<std::string, RmfLayer> layers;
  std::vector<std::array<std::string, 2>> constraints;  ///< ids of marks that show the same real place
  std::vector<RmfMark> vertices;
  std::vector<std::array<std::size_t, 2>> lanes;  ///< indices of vertices
};

/// What Open-RMF's traffic editor saves as `*.building.yaml`, as far as it tells places.
struct RmfBuilding {
  std::map<std::string, RmfLevel> levels;
};

/// kMalformed names the value; a constraint or lane to something that does not exist is left out by the editor as well
/// and not an error.
[[nodiscard]] Result<RmfBuilding> parseRmfBuilding(const std::string& text, const std::string& file_name);
[[nodiscard]] Result<RmfBuilding> readRmfBuilding(const std::filesystem::path& path);

/// The level of that name; with an empty name the only one. kNotFound lists the names.
[[nodiscard]] Result<RmfLevel> findLevel(const RmfBuilding& building, const std::string& name);

/// Anchors of one layer: pairs of marks that constraints join. Their pixels, whose rows grow down, become metres
/// through the frames of both maps. kNotFound: no such layer (lists the names) or no pair; kOutOfDomain: a mark outside
/// its picture, which means that a frame belongs to another picture.
[[nodiscard]] Result<AnchorList> anchorsOf(const RmfLevel& level, const std::string& layer, const MapFrame& blueprint,
                                           const MapFrame& slam);

/// Lanes and named vertices in the blueprint frame.
[[nodiscard]] FeatureList lanesOf(const RmfLevel& level, const MapFrame& blueprint);

}  // namespace cad2slam
