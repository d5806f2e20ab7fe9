// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
//
// Writes a site as large as maps get, for gui_bench and for looking at it: a blueprint of 30 000 x 30 000 pixels as
// TIFF, a SLAM map of 8 000 x 8 000 and 200 anchors.
// Usage: large_site FOLDER [BLUEPRINT_SIDE_PX] [SLAM_SIDE_PX] [ANCHORS]

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "cad2slam/io/anchors_csv.h"
#include "cad2slam/io/atomic_file.h"
#include "cad2slam/io/map_file.h"
#include "cad2slam/io/map_yaml.h"
#include "cad2slam/projection/overlay_picture.h"
#include "cad2slam/simulation/site_generator.h"

namespace {

using namespace cad2slam;

constexpr double kSide_m = 290.0;
constexpr double kMargin_m = 5.0;
constexpr int kWallStep_px = 3;  // walls are drawn into the SLAM map from every third pixel of the blueprint

int tell(const Error& error) {
  std::fprintf(stderr, "large_site: %s\n", error.sentence().c_str());
  return 1;
}

cv::Mat slamPictureOf(const GeneratedSite& site, const OccupancyGrid& blueprint, const MapFrame& frame) {
  cv::Mat picture(frame.height(), frame.width(), CV_8UC1, cv::Scalar(254));
  for (int row = 0; row < blueprint.frame().height(); row += kWallStep_px) {
    for (int column = 0; column < blueprint.frame().width(); column += kWallStep_px) {
      if (blueprint.at(column, row) != CellState::kOccupied) continue;
      const Eigen::Vector2d place = blueprint.frame().metricFromPixel({column + 0.5, row + 0.5});
      const Eigen::Vector2d pixel = frame.pixelFromMetric(site.slamFromBlueprint({place, 0.0}).translation);
      const cv::Point target(static_cast<int>(pixel.x()), static_cast<int>(pixel.y()));
      if (cv::Rect(0, 0, picture.cols, picture.rows).contains(target)) picture.at<std::uint8_t>(target) = 0;
    }
  }
  cv::erode(picture, picture, cv::Mat());
  return picture;
}

int write(const std::filesystem::path& folder, int blueprint_px, int slam_px, int anchors) {
  SiteRecipe recipe;
  recipe.building.plan = {SiteKind::kOffice, {kSide_m, kSide_m}, CorridorShape::kU};
  recipe.building.margin_m = kMargin_m;
  recipe.building.resolution_m_per_px = 0.1;  // anchors are chosen on a small drawing
  recipe.warp.bend_rad = 0.05;
  recipe.warp.wave_m = 1.0;
  recipe.warp.wave_length_m = 100.0;  // several anchors to a wave
  recipe.warp.slam_from_plan = {{20.0, 20.0}, 0.1};
  recipe.anchors.count = anchors;
  const Result<GeneratedSite> site = generateSite(recipe);
  if (!site) return tell(site.error());
  MapMetadata blueprint;
  blueprint.resolution_m_per_px = (kSide_m + 2.0 * kMargin_m) / blueprint_px;
  blueprint.metric_from_corner = site->building.blueprint.frame().metricFromCorner();
  const Result<MapFrame> fine =
      MapFrame::create(blueprint.resolution_m_per_px, blueprint_px, blueprint_px, blueprint.metric_from_corner);
  if (!fine) return tell(fine.error());
  const OccupancyGrid drawing = drawPlan(site->building.plan, *fine, site->building.blueprint_from_plan);

  std::filesystem::create_directories(folder);
  // writeMap() writes PNG and PGM; a TIFF is what a plan office sends.
  if (!cv::imwrite((folder / "blueprint.tif").string(), trinaryPicture(drawing))) return 1;
  const std::string yaml = formatMapYaml(blueprint, "blueprint.tif");
  if (const auto done = writeFileAtomically(folder / "blueprint.yaml", yaml); !done) return tell(done.error());

  const Pose2 corner = {{-40.0, -10.0}, 0.0};
  const Result<MapFrame> frame = MapFrame::create(400.0 / slam_px, slam_px, slam_px, corner);
  if (!frame) return tell(frame.error());
  MapMetadata slam;
  slam.resolution_m_per_px = frame->resolution();
  slam.metric_from_corner = corner;
  if (const auto done = writeMap(folder / "slam.yaml", "slam.png", slamPictureOf(*site, drawing, *frame), slam); !done)
    return tell(done.error());
  if (const auto done = writeAnchorsCsv(folder / "anchors.csv", site->anchors); !done) return tell(done.error());
  std::printf("blueprint of %d x %d pixels, SLAM map of %d x %d, %zu anchors\n", blueprint_px, blueprint_px, slam_px,
              slam_px, site->anchors.size());
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fprintf(stderr, "usage: large_site FOLDER [BLUEPRINT_SIDE_PX] [SLAM_SIDE_PX] [ANCHORS]\n");
    return 2;
  }
  const auto number = [&](int index, int otherwise) { return argc > index ? std::atoi(argv[index]) : otherwise; };
  return write(argv[1], number(2, 30'000), number(3, 8'000), number(4, 200));
}
