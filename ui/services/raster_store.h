// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cad2slam/io/map_file.h"
#include "cad2slam/map/occupancy_grid.h"
#include "ui/document/project_document.h"
#include "ui/services/tile_pyramid.h"
#include "ui/views/lane.h"

#include <QObject>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace cad2slam {

/// What is wrong with an image of the project.
struct RasterProblem {
  enum class Kind { kMissing, kUnreadable, kChanged };
  Kind kind = Kind::kMissing;
  Side side = Side::kBlueprint;
  std::string map;  ///< name of the SLAM map, for Side::kSlam
  std::filesystem::path image;
  QString sentence;
  std::uintmax_t found_bytes = 0;  ///< with kChanged: what the image is now
  std::string found_sha256;
};

/// Loads the images of a document in the background: the picture to draw, the frame, and for the blueprint what is
/// free. Follows the document; anything slow happens on another thread.
class RasterStore : public QObject {
  Q_OBJECT

 public:
  explicit RasterStore(ProjectDocument& document, QObject* parent = nullptr);
  ~RasterStore() override;

  /// Null or empty until loaded; the frame and the picture of a large image come before its grid. The SLAM map is the
  /// current one.
  [[nodiscard]] const std::optional<MapFrame>& frame(Side side) const { return at(side).frame; }
  [[nodiscard]] const std::shared_ptr<TilePyramid>& picture(Side side) const { return at(side).picture; }
  [[nodiscard]] const std::shared_ptr<const OccupancyGrid>& grid(Side side) const { return at(side).grid; }
  /// SHA-256 of the image that is shown, which need not be the one the project was made with.
  [[nodiscard]] const std::string& imageHash(Side side) const { return at(side).image_sha256; }
  [[nodiscard]] bool isImageChanged(Side side) const { return at(side).image_changed; }
  [[nodiscard]] bool isLoading() const { return slots_[0].loading || slots_[1].loading; }

 signals:
  /// Picture, frame or grid of a side are there, others, or gone. `new_picture`: not just another frame for it.
  void changed(cad2slam::Side side, bool new_picture);
  void problem(const cad2slam::RasterProblem& problem);
  /// What was told of the image of a side holds no more: it is gone, read anew or accepted.
  void problemsOver(cad2slam::Side side);
  void warned(const QString& sentence);

 private:
  /// What tells without reading it that an image file is still the same.
  struct FileStamp {
    std::uintmax_t bytes = 0;
    std::filesystem::file_time_type written;

    friend bool operator==(const FileStamp&, const FileStamp&) = default;
  };
  struct Slot {
    std::optional<MapMetadata> wanted;
    std::string map;              // that it was asked for
    std::string recorded_sha256;  // of the image the project wants; empty: any
    std::optional<FileStamp> stamp;
    std::optional<MapFrame> frame;
    std::shared_ptr<TilePyramid> picture;
    std::shared_ptr<const OccupancyGrid> grid;
    std::string image_sha256;
    bool image_changed = false;
    bool loading = false;
    int ticket = 0;  // of the newest request; answers to older ones are dropped

    void clear() {
      const int next = ticket + 1;
      *this = Slot();
      ticket = next;
    }
  };
  struct Answer;

  [[nodiscard]] Slot& at(Side side) { return slots_[side == Side::kBlueprint ? 0 : 1]; }
  [[nodiscard]] const Slot& at(Side side) const { return slots_[side == Side::kBlueprint ? 0 : 1]; }
  [[nodiscard]] static std::optional<FileStamp> stampOf(const std::filesystem::path& image);
  void follow(Side side, const ProjectRaster* raster, const std::string& map);
  [[nodiscard]] static bool holds(const Slot& slot, const ProjectRaster& raster, const std::string& map);
  void reframe(Side side, const MapMetadata& metadata);
  void load(Side side, const ProjectRaster& raster, const std::string& map);
  void read(Side side, const ProjectRaster& raster, const std::string& map);
  void showEarly(Side side, int ticket, const ProjectRaster& raster, const MapFrame& frame);
  void take(Side side, int ticket, const ProjectRaster& raster, const std::string& map, const Answer& answer);

  ProjectDocument& document_;
  Slot slots_[2];
  Lane lane_{2};  // one for each side
};

}  // namespace cad2slam

Q_DECLARE_METATYPE(cad2slam::RasterProblem)
Q_DECLARE_METATYPE(cad2slam::Side)
