// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/services/raster_store.h"

#include "cad2slam/io/project_file.h"
#include "ui/convert.h"
#include "ui/engine_sentences.h"
#include "ui/services/guarded.h"

#include <QFutureWatcher>
#include <QTimer>

#include <system_error>
#include <utility>

namespace cad2slam {
namespace {

/// Whether the pixels and what they mean are the same, so that only the metric frame differs.
bool samePixels(const MapMetadata& a, const MapMetadata& b) {
  return a.image == b.image && a.mirrored == b.mirrored && a.negate == b.negate && a.mode == b.mode &&
         a.occupied_threshold == b.occupied_threshold && a.free_threshold == b.free_threshold;
}

bool isLarge(const MapFrame& frame) {
  return std::int64_t{frame.width()} * frame.height() > 16'000'000;
}

}  // namespace

struct RasterStore::Answer {
  Result<MapFrame> frame = fail(ErrorCode::kInternal, "not loaded");
  std::shared_ptr<const OccupancyGrid> grid;
  RasterState state = RasterState::kUnchanged;
  ProjectRaster described;
  std::vector<std::string> warnings;
};

RasterStore::RasterStore(ProjectDocument& document, QObject* parent) : QObject(parent), document_(document) {
  connect(&document_, &ProjectDocument::changed, this, [this](const ChangeEvent& event) {
    if (event.what & Change::kEverything)
      for (Slot& slot : slots_) slot.clear();
    if (event.what & (Change::kEverything | Change::kBlueprint))
      follow(Side::kBlueprint, document_.hasBlueprint() ? &document_.project().blueprint : nullptr, {});
    if (event.what & (Change::kEverything | Change::kSlamMaps | Change::kCurrentMap)) {
      const ProjectSlamMap* map = document_.currentMap();
      follow(Side::kSlam, map ? &map->raster : nullptr, map ? map->name : std::string());
    }
  });
}

RasterStore::~RasterStore() = default;

std::optional<RasterStore::FileStamp> RasterStore::stampOf(const std::filesystem::path& image) {
  std::error_code error;
  FileStamp stamp;
  stamp.bytes = std::filesystem::file_size(image, error);
  if (error) return std::nullopt;
  stamp.written = std::filesystem::last_write_time(image, error);
  return error ? std::nullopt : std::optional(stamp);
}

/// Whether what is shown, or being read, is the image that is wanted now, so that only the metric frame may differ.
bool RasterStore::holds(const Slot& slot, const ProjectRaster& raster, const std::string& map) {
  if (!slot.frame || !samePixels(*slot.wanted, raster.metadata)) return false;
  // A file that is gone tells nothing better than what was read of it.
  if (const auto now = stampOf(raster.metadata.image); now && now != slot.stamp) return false;
  if (slot.loading) return raster.image_sha256 == slot.recorded_sha256 && map == slot.map;
  if (slot.image_changed && map != slot.map) return false;  // what was told names the other one
  // Chosen anew: the installer knows of another picture in the file, whatever its time says.
  if (raster.image_sha256.empty()) return false;
  return raster.image_sha256 == slot.image_sha256 || raster.image_sha256 == slot.recorded_sha256;
}

void RasterStore::follow(Side side, const ProjectRaster* raster, const std::string& map) {
  Slot& slot = at(side);
  if (!raster || raster->metadata.image.empty()) {
    slot.clear();
    emit problemsOver(side);
    emit changed(side, true);
  } else if (holds(slot, *raster, map)) {
    slot.recorded_sha256 = raster->image_sha256;
    if (slot.image_changed && slot.recorded_sha256 == slot.image_sha256) {
      slot.image_changed = false;
      emit problemsOver(side);
    }
    reframe(side, raster->metadata);
  } else {
    load(side, *raster, map);
  }
}

void RasterStore::reframe(Side side, const MapMetadata& metadata) {
  Slot& slot = at(side);
  if (isSameFrame(*slot.wanted, metadata)) return emit changed(side, false);
  const Result<MapFrame> frame = MapFrame::create(metadata.resolution_m_per_px, slot.frame->width(),
                                                  slot.frame->height(), metadata.metric_from_corner);
  if (!frame) return;
  slot.wanted = metadata;
  slot.frame = *frame;
  if (slot.grid) slot.grid = std::make_shared<const OccupancyGrid>(slot.grid->withFrame(*frame));
  emit changed(side, false);
}

void RasterStore::load(Side side, const ProjectRaster& raster, const std::string& map) {
  Slot& slot = at(side);
  slot.clear();
  slot.wanted = raster.metadata;
  slot.map = map;
  slot.recorded_sha256 = raster.image_sha256;
  slot.stamp = stampOf(raster.metadata.image);  // before the first byte is read: a later change is seen
  slot.loading = true;
  const int ticket = slot.ticket;
  emit problemsOver(side);
  emit changed(side, true);
  // After what is already waiting to be painted, for which the threads would take the processors away.
  QTimer::singleShot(1, this, [this, side, raster, map, ticket] {
    if (at(side).ticket == ticket) read(side, raster, map);
  });
}

void RasterStore::read(Side side, const ProjectRaster& raster, const std::string& map) {
  Slot& slot = at(side);
  const int ticket = slot.ticket;
  slot.picture = TilePyramid::load(raster.metadata.image, raster.metadata.mirrored);
  connect(slot.picture.get(), &TilePyramid::failed, this, [this, side, ticket, raster, map](const QString& sentence) {
    if (at(side).ticket != ticket) return;  // of another image by now, or already told
    at(side).clear();
    emit problem({RasterProblem::Kind::kUnreadable, side, map, raster.metadata.image, sentence, 0, {}});
    emit changed(side, true);
  });
  auto* watcher = new QFutureWatcher<Answer>(this);
  connect(watcher, &QFutureWatcher<Answer>::finished, this, [this, watcher, side, ticket, raster, map] {
    watcher->deleteLater();
    take(side, ticket, raster, map, watcher->result());
  });
  const bool want_grid = side == Side::kBlueprint;
  watcher->setFuture(lane_.run<Answer>([this, side, ticket, raster, want_grid](QPromise<Answer>& promise) {
    Answer answer;
    const Result<void> done = guarded([&]() -> Result<void> {
      answer.state = checkRaster(raster);
      if (want_grid) {
        // A large picture is shown as soon as its frame is known: to find what is free takes seconds then. A small one
        // comes with its grid, so that the window is painted once, and when the processors are free.
        if (const Result<MapFrame> frame = readMapFrame(raster.metadata); frame && isLarge(*frame)) {
          QMetaObject::invokeMethod(
              this, [=, this, frame = *frame] { showEarly(side, ticket, raster, frame); }, Qt::QueuedConnection);
        }
        Result<LoadedMap> loaded = loadMap(raster.metadata);
        if (!loaded) return failAs(loaded);
        answer.frame = loaded->grid.frame();
        answer.grid = std::make_shared<const OccupancyGrid>(loaded->grid);
        answer.warnings = std::move(loaded->warnings);
      } else {
        answer.frame = readMapFrame(raster.metadata);
        if (!answer.frame) return failAs(answer.frame);
      }
      if (raster.image_sha256.empty() || answer.state == RasterState::kChanged)
        if (Result<ProjectRaster> described = describeRaster(raster.metadata)) answer.described = *std::move(described);
      return {};
    });
    if (!done) answer.frame = failAs(done);
    promise.addResult(std::move(answer));
  }));
}

void RasterStore::showEarly(Side side, int ticket, const ProjectRaster& raster, const MapFrame& frame) {
  Slot& slot = at(side);
  if (slot.ticket != ticket || slot.frame) return;
  // The document may have been rescaled since; take() sees to it in the end.
  if (!isSameFrame(*slot.wanted, raster.metadata)) return;
  slot.frame = frame;
  emit changed(side, true);
}

void RasterStore::take(Side side, int ticket, const ProjectRaster& raster, const std::string& map,
                       const Answer& answer) {
  Slot& slot = at(side);
  if (slot.ticket != ticket) return;
  slot.loading = false;
  if (!answer.frame) {
    slot.clear();
    const bool missing = answer.state == RasterState::kMissing || answer.frame.error().code == ErrorCode::kNotFound;
    emit problem({missing ? RasterProblem::Kind::kMissing : RasterProblem::Kind::kUnreadable,
                  side,
                  map,
                  raster.metadata.image,
                  toSentence(answer.frame.error()),
                  0,
                  {}});
    return emit changed(side, true);
  }
  const bool is_shown = slot.frame.has_value();
  // The document may have been rescaled while the image was being read.
  const MapMetadata wanted = *slot.wanted;
  slot.wanted = raster.metadata;
  slot.frame = *answer.frame;
  slot.grid = answer.grid;
  slot.image_sha256 = answer.described.image_sha256.empty() ? raster.image_sha256 : answer.described.image_sha256;
  slot.image_changed = answer.state == RasterState::kChanged;
  if (!isSameFrame(wanted, raster.metadata)) reframe(side, wanted);
  if (!answer.described.image_sha256.empty())
    document_.describeRasters(map, side == Side::kBlueprint ? answer.described : ProjectRaster{},
                              side == Side::kSlam ? answer.described : ProjectRaster{});
  emit changed(side, !is_shown);
  if (answer.state == RasterState::kChanged)
    emit problem({RasterProblem::Kind::kChanged, side, map, raster.metadata.image,
                  tr("%1 is not the image this project was made with; check that the anchors still fit")
                      .arg(toQString(raster.metadata.image.filename())),
                  answer.described.image_bytes, answer.described.image_sha256});
  for (const std::string& warning : answer.warnings) emit warned(translatedSentence(warning));
}

}  // namespace cad2slam
