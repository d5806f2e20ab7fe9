// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include <cstdint>

#include "cad2slam/io/project_file.h"
#include "fuzz/require.h"

using namespace cad2slam;

/// What is read is written, read again and written as the same text.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
  const std::filesystem::path path = "/site/p.c2sproj";
  const Result<Project> read = parseProject(std::string(reinterpret_cast<const char*>(bytes), count), path);
  if (!read) {
    fuzz::require(!read.error().message.empty() && read.error().where.rfind(path.string(), 0) == 0,
                  "error without place");
    return 0;
  }
  const std::string written = formatProject(*read, path);
  const Result<Project> again = parseProject(written, path);
  fuzz::require(again.has_value(), again ? "" : "written project is refused: " + again.error().message + written);
  fuzz::require(formatProject(*again, path) == written, "no fixed point: " + written);
  fuzz::require(again->slam_maps.size() == read->slam_maps.size(), "maps are lost");
  for (std::size_t k = 0; k < read->slam_maps.size(); ++k) {
    fuzz::require(again->slam_maps[k].anchors == read->slam_maps[k].anchors, "anchors change");
    fuzz::require(again->slam_maps[k].raster.metadata.image == read->slam_maps[k].raster.metadata.image,
                  "image changes: " + written);
  }
  return 0;
}
