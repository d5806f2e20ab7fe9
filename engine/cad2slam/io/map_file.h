// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "cad2slam/core/result.h"
#include "cad2slam/map/map_frame.h"
#include "cad2slam/map/occupancy_grid.h"

namespace cad2slam {

/// Which map_server a map is read like; they differ for colour, alpha and values on a threshold.
enum class MapSemantics {
  kJazzy,   ///< ROS 2 jazzy and later (default)
  kHumble,  ///< ROS 1 and ROS 2 up to humble
};

enum class MapMode { kTrinary, kScale, kRaw };

/// Which numbers are read and written.
struct NumberRange {
  double least;
  double most;

  [[nodiscard]] constexpr bool holds(double number) const { return number >= least && number <= most; }
};
inline constexpr NumberRange kResolutionRange{1e-6, 1e4};  ///< of a map [m/px]

/// A map_server YAML as read: `image` is resolved against the folder of the YAML.
struct MapMetadata {
  std::filesystem::path yaml;  ///< empty for a bare image
  std::filesystem::path image;
  double resolution_m_per_px = 0.05;
  Pose2 metric_from_corner;  ///< `origin:`
  double occupied_threshold = 0.65;
  double free_threshold = 0.196;
  bool negate = false;
  MapMode mode = MapMode::kTrinary;
  bool mirrored = false;  ///< columns are read from right to left; only a project says so, a YAML cannot
};

/// A map YAML with what a user should hear of it, e.g. of a yaw that other programs ignore.
struct MapYaml {
  MapMetadata metadata;
  std::vector<std::string> warnings;
};

struct MapReadOptions {
  MapSemantics semantics = MapSemantics::kJazzy;
};

/// An occupancy grid and what was found on the way.
struct LoadedMap {
  MapMetadata metadata;
  OccupancyGrid grid;
  std::vector<std::string> warnings;  ///< e.g. pixel 205 counted as free; of the YAML too when that was read
};

/// Reads the YAML only. Every error names the file, the line and the key.
[[nodiscard]] Result<MapYaml> readMapYaml(const std::filesystem::path& yaml);

/// Reads YAML and image (PGM, PNG, JPG, BMP, TIFF; 8 or 16 bit; grey, colour, alpha) and classifies every pixel.
/// Up to 30 000 x 30 000 px, of which only a few rows lie in memory as they are.
[[nodiscard]] Result<LoadedMap> loadMap(const std::filesystem::path& yaml, const MapReadOptions& options = {});
[[nodiscard]] Result<LoadedMap> loadMap(const MapMetadata& metadata, const MapReadOptions& options = {});

/// Frame of a map without decoding its pixels' values into states; reads only the image's size.
[[nodiscard]] Result<MapFrame> readMapFrame(const MapMetadata& metadata);

/// The picture as it is, for drawing and warping: CV_8U or CV_16U with 1, 3 (BGR) or 4 (BGRA) channels.
[[nodiscard]] Result<cv::Mat> loadPicture(const std::filesystem::path& image);

/// Writes a picture of 8 or 16 bits with 1, 3 (BGR) or 4 (BGRA) channels, atomically; .png, or .pgm for grey.
[[nodiscard]] Result<void> writePicture(const std::filesystem::path& image, const cv::Mat& picture);

/// Writes picture (format by extension, .pgm or .png) and YAML beside each other, both atomically and with numbers that
/// read back exactly; the YAML names the image by file name.
[[nodiscard]] Result<void> writeMap(const std::filesystem::path& yaml, const std::string& image_name,
                                    const cv::Mat& picture, const MapMetadata& metadata);

}  // namespace cad2slam
