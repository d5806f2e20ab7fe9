// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/main_window/preview_wiring.h"

#include <algorithm>
#include <array>

#include <QEvent>

#include "ui/convert.h"
#include "ui/engine_sentences.h"
#include "ui/main_window/mesh_overlay.h"
#include "ui/models/foreign_text.h"
#include "ui/panels/marker_class.h"

namespace cad2slam {
namespace {

const QColor kGreyInk(0x55, 0x5a, 0x60);
// Of all SLAM maps over one blueprint; told apart by lightness as well.
const std::array<QColor, 6> kMapInks{QColor(0xe0, 0x00, 0x84), QColor(0x00, 0x9a, 0x44), QColor(0x1f, 0x5f, 0xd8),
                                     QColor(0xd9, 0x7a, 0x00), QColor(0x6a, 0x2f, 0xb5), QColor(0x00, 0x95, 0xa8)};

}  // namespace

PreviewRaster previewRaster(const RasterStore& rasters, Side side) {
  return {rasters.picture(side)->store(), rasters.frame(side)};
}

PreviewWiring::PreviewWiring(Session& session, PreviewPanel& panel, QObject* parent)
    : QObject(parent), session_(session), panel_(panel) {
  PreviewView& view = panel_.view();
  view.setEmptyText(tr("Load a blueprint and a SLAM map to see them over each other"));
  view.installEventFilter(this);
  connect(&view, &PreviewView::pictureWanted, this, &PreviewWiring::askForPicture);
  // Not at the press, which may begin a pan.
  connect(&view, &MapView::markerClicked, this, [this](MarkerId id, Qt::KeyboardModifiers modifiers) {
    const bool more = modifiers & (Qt::ControlModifier | Qt::ShiftModifier);
    more ? session_.selection().toggle(id) : session_.selection().set({id});
  });
  connect(&view, &MapView::markerDoubleClicked, this, &PreviewWiring::centeringWanted);
  connect(&panel_, &PreviewPanel::modeChanged, this, &PreviewWiring::refresh);
  connect(&panel_, &PreviewPanel::directionChanged, this, &PreviewWiring::refresh);
  connect(&service_, &PreviewService::pictureReady, &view, &PreviewView::setPicture);
  connect(&service_, &PreviewService::failed, this, &PreviewWiring::failed);
  connect(&session_.alignment(), &Alignment::resultChanged, this, &PreviewWiring::refresh);
  connect(&session_.alignment(), &Alignment::statusChanged, this, [this] {
    panel_.view().setReason(reason());
    panel_.view().setNotCurrent(notCurrent());
  });
  connect(&session_.alignment(), &Alignment::othersChanged, this, [this] {
    if (panel_.mode() == PreviewMode::kAllMaps && panel_.view().isVisible()) refresh();
  });
  connect(&session_.rasters(), &RasterStore::changed, this, &PreviewWiring::refresh);
  connect(&session_, &Session::judged, this, &PreviewWiring::refreshOverlays);
  connect(&session_.selection(), &AnchorSelection::changed, this, &PreviewWiring::refreshOverlays);
}

bool PreviewWiring::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Show && stale_)
    QMetaObject::invokeMethod(this, &PreviewWiring::refresh, Qt::QueuedConnection);
  if (event->type() == QEvent::Hide) session_.alignment().setOthersWanted(false);
  return QObject::eventFilter(watched, event);
}

void PreviewWiring::follow(const std::shared_ptr<TilePyramid>& picture) {
  if (picture)
    // Queued: to draw anew may let go of the very picture that tells of its tiles.
    connect(picture.get(), &RasterSource::tilesChanged, this, &PreviewWiring::onTilesChanged,
            static_cast<Qt::ConnectionType>(Qt::QueuedConnection | Qt::UniqueConnection));
}

void PreviewWiring::onTilesChanged() {
  if (panel_.view().isVisible()) refresh();
}

bool PreviewWiring::hasOtherResults() const {
  return panel_.mode() == PreviewMode::kAllMaps && session_.rasters().frame(Side::kBlueprint) &&
         !session_.alignment().results().empty();
}

QString PreviewWiring::reason() const {
  if (hasOtherResults()) return {};
  if (!session_.isReady()) return tr("Load a blueprint and a SLAM map first");
  if (session_.alignment().result()) return {};
  switch (session_.alignment().status()) {
    case AlignmentStatus::kNotReady:  // a large blueprint is shown before its cells are known
      return tr("Loading the images...");
    case AlignmentStatus::kNoAnchors:
      return tr("Nothing to lay over it yet: place an anchor in both views");
    case AlignmentStatus::kFailed:
      return session_.alignment().error() ? toSentence(*session_.alignment().error()) : QString();
    default:
      return tr("Solving...");
  }
}

bool PreviewWiring::isRough() const {
  const SolveResultPtr& result = session_.alignment().result();
  return result && result->solution.anchors_used == 1;
}

QString PreviewWiring::notCurrent() const {
  const AlignmentStatus status = session_.alignment().status();
  if (!session_.alignment().result()) return {};
  if (status == AlignmentStatus::kFailed) return tr("Not current: the last solve failed, this is the result before it");
  if (status == AlignmentStatus::kCancelled) return tr("Not current: the last solve was stopped");
  if (isRough()) return tr("Rough: one anchor says nothing of the turn");
  return {};
}

void PreviewWiring::showBase() {
  const Side side = baseSide();
  const std::optional<MapFrame>& frame = session_.rasters().frame(side);
  // A picture may be there before its frame is.
  const std::shared_ptr<TilePyramid> picture = frame ? session_.rasters().picture(side) : nullptr;
  PreviewView& view = panel_.view();
  if (picture == base_picture_) {
    if (frame) view.reframe(*frame);
    return;
  }
  if (frame) view.setFrame(*frame);
  base_picture_ = picture;
  view.clearPicture();
  view.setImage(picture);
  if (picture) view.fit();
}

QString PreviewWiring::nameInLegend(const std::string& map) const {
  const Alignment& alignment = session_.alignment();
  const bool current = map == session_.document().currentMapName();
  const QString name = shortened(toQString(map));
  switch (current ? alignment.status() : alignment.otherStatus(map)) {
    case AlignmentStatus::kNoAnchors:
      return tr("%1 (no anchors)").arg(name);
    case AlignmentStatus::kSolving:
      // While one edits, the current one is solved all the time.
      return current && alignment.result() ? name : tr("%1 (solving...)").arg(name);
    case AlignmentStatus::kFailed:
      return tr("%1 (cannot be solved)").arg(name);
    case AlignmentStatus::kCancelled:
      return tr("%1 (stopped)").arg(name);
    default:
      return name;
  }
}

PreviewWiring::OtherMap& PreviewWiring::otherMap(const ProjectSlamMap& map) {
  const MapMetadata& metadata = map.raster.metadata;
  OtherMap& other = other_maps_[map.name];
  if (!other.picture || other.metadata.image != metadata.image || !isSameFrame(other.metadata, metadata)) {
    other.metadata = metadata;
    const Result<MapFrame> frame = readMapFrame(metadata);
    other.frame = frame ? std::optional(*frame) : std::nullopt;
    other.picture = TilePyramid::load(metadata.image, metadata.mirrored);
    follow(other.picture);
  }
  return other;
}

void PreviewWiring::addAllMaps(PreviewScene& scene, std::vector<InkEntry>& inks) {
  const auto& maps = session_.document().project().slam_maps;
  std::erase_if(other_maps_, [&](const auto& entry) {
    return std::none_of(maps.begin(), maps.end(), [&](const auto& map) { return map.name == entry.first; });
  });
  std::size_t number = 0;  // an ink stays with its map, whichever maps are solved
  for (const ProjectSlamMap& map : maps) {
    const QColor ink = kMapInks[number++ % kMapInks.size()];
    inks.push_back({ink, nameInLegend(map.name)});
    const auto result = session_.alignment().results().find(map.name);
    if (result == session_.alignment().results().end()) continue;
    if (map.name == session_.document().currentMapName()) {
      if (session_.isReady())
        scene.layers.push_back({previewRaster(session_.rasters(), Side::kSlam), result->second->projector, ink});
    } else if (const OtherMap& other = otherMap(map); other.frame) {
      scene.layers.push_back({{other.picture->store(), other.frame}, result->second->projector, ink});
    }
  }
}

void PreviewWiring::refresh() {
  PreviewView& view = panel_.view();
  stale_ = !view.isVisible();
  if (stale_) return;
  const bool all = panel_.mode() == PreviewMode::kAllMaps;
  session_.alignment().setOthersWanted(all);
  if (!all) other_maps_.clear();
  showBase();
  view.setReason(reason());
  view.setNotCurrent(notCurrent());
  view.setRough(isRough());
  const Side below = baseSide();
  const Side above = otherSide(below);
  for (const Side side : {below, above}) follow(session_.rasters().picture(side));
  const QString blueprint_name = tr("Blueprint");
  const QString slam_name = shortened(toQString(session_.document().currentMapName()));
  const auto inkOf = [](Side side) { return side == Side::kBlueprint ? kBlueprintInk : kSlamInk; };
  const auto nameOf = [&](Side side) { return side == Side::kBlueprint ? blueprint_name : slam_name; };
  auto scene = std::make_shared<PreviewScene>();
  scene->direction = below == Side::kBlueprint ? WarpDirection::kToBlueprint : WarpDirection::kToSlam;
  scene->base_ink = all ? kGreyInk : inkOf(below);
  std::vector<InkEntry> inks{{scene->base_ink, nameOf(below)}};
  const SolveResultPtr& result = session_.alignment().result();
  if (all) {
    addAllMaps(*scene, inks);
  } else {
    inks.push_back({inkOf(above), nameOf(above)});
    if (result && session_.isReady())
      scene->layers.push_back({previewRaster(session_.rasters(), above), result->projector, inkOf(above)});
  }
  view.setInks(std::move(inks));
  if (scene->layers.empty() || !session_.rasters().frame(below)) {
    service_.setScene(nullptr);
    view.clearPicture();
    refreshOverlays();
    return;
  }
  if (result) {
    for (const Anchor& anchor : result->anchors)
      if (anchor.enabled) scene->anchors.push_back(anchor.in_blueprint);
  }
  scene->base = previewRaster(session_.rasters(), below);
  service_.setScene(std::move(scene));
  refreshOverlays();
  askForPicture();
}

void PreviewWiring::refreshOverlays() {
  PreviewView& view = panel_.view();
  if (!view.isVisible()) {
    stale_ = true;
    return;
  }
  const Side side = baseSide();
  const SolveResultPtr& result = session_.alignment().result();
  std::vector<Marker> markers;
  std::vector<ResidualVector> residuals;
  for (const Anchor& anchor : session_.document().anchors()) {
    Marker marker;
    marker.id = anchor.id;
    marker.text = QString::number(anchor.id);
    marker.point_m = toQPointF(side == Side::kBlueprint ? anchor.in_blueprint : anchor.in_slam);
    const auto judgement = session_.judgements().find(anchor.id);
    if (judgement != session_.judgements().end()) marker.judged = markerClass(judgement->second.judged);
    if (!anchor.enabled) marker.judged = MarkerClass::kDisabled;
    marker.selected = session_.selection().contains(anchor.id);
    if (result && panel_.mode() == PreviewMode::kResiduals) {
      const Projection there =
          side == Side::kBlueprint
              ? result->projector.blueprintFromSlam({anchor.in_slam, 0.0}, OutsidePolicy::kRigid)
              : result->projector.slamFromBlueprint({anchor.in_blueprint, 0.0}, OutsidePolicy::kRigid);
      if (there.ok()) residuals.push_back({toQPointF(there.pose.translation), marker.point_m, marker.judged});
    }
    markers.push_back(std::move(marker));
  }
  view.setMarkers(std::move(markers));
  view.setResiduals(std::move(residuals), MapView::kAutomaticMagnification);
  if (result && panel_.mode() == PreviewMode::kMesh) {
    const auto mesh = side == Side::kBlueprint ? meshInBlueprint(*result) : meshInSlam(*result);
    view.setMesh(mesh);
  } else {
    view.setMesh(nullptr);
  }
}

void PreviewWiring::askForPicture() {
  PreviewView& view = panel_.view();
  if (!service_.scene() || !view.isVisible() || view.size().isEmpty()) return;
  const QSize margin = (QSizeF(view.size()) * PreviewView::kMargin).toSize();
  service_.request(previewKind(view.mode()), view.viewState(), view.size() + 2 * margin, view.devicePixelRatioF());
}

}  // namespace cad2slam
