// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/main_window/preview_wiring.h"

#include <algorithm>
#include <array>

#include <QEvent>

#include "ui/convert.h"
#include "ui/main_window/marker_class.h"
#include "ui/main_window/mesh_overlay.h"

namespace cad2slam {
namespace {

constexpr double kMagnification = 10.0;
const QColor kBlueprintInk(0xe0, 0x00, 0x84);
const QColor kSlamInk(0x00, 0x9a, 0x44);
const QColor kGreyInk(0x55, 0x5a, 0x60);
// Of all SLAM maps over one blueprint; told apart by lightness as well.
const std::array<QColor, 6> kMapInks{QColor(0xe0, 0x00, 0x84), QColor(0x00, 0x9a, 0x44), QColor(0x1f, 0x5f, 0xd8),
                                     QColor(0xd9, 0x7a, 0x00), QColor(0x6a, 0x2f, 0xb5), QColor(0x00, 0x95, 0xa8)};

}  // namespace

PreviewWiring::PreviewWiring(Session& session, PreviewPanel& panel, QObject* parent)
    : QObject(parent), session_(session), panel_(panel) {
  PreviewView& view = panel_.view();
  view.setEmptyText(tr("Load a blueprint and a SLAM map to see them over each other"));
  view.installEventFilter(this);
  connect(&view, &PreviewView::pictureWanted, this, &PreviewWiring::askForPicture);
  connect(&panel_, &PreviewPanel::modeChanged, this, &PreviewWiring::refresh);
  connect(&panel_, &PreviewPanel::directionChanged, this, &PreviewWiring::refresh);
  connect(&service_, &PreviewService::pictureReady, &view, &PreviewView::setPicture);
  connect(&service_, &PreviewService::failed, this, &PreviewWiring::failed);
  connect(&session_.alignment(), &Alignment::resultChanged, this, &PreviewWiring::refresh);
  connect(&session_.alignment(), &Alignment::statusChanged, this, [this] {
    panel_.view().setReason(reason());
    panel_.view().setNotCurrent(notCurrent());
  });
  connect(&session_.rasters(), &RasterStore::changed, this, &PreviewWiring::refresh);
  connect(&session_, &Session::judged, this, &PreviewWiring::refreshOverlays);
  connect(&session_.selection(), &AnchorSelection::changed, this, &PreviewWiring::refreshOverlays);
}

bool PreviewWiring::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Show && stale_)
    QMetaObject::invokeMethod(this, &PreviewWiring::refresh, Qt::QueuedConnection);
  return QObject::eventFilter(watched, event);
}

void PreviewWiring::follow(const std::shared_ptr<TilePyramid>& picture) {
  if (picture)
    connect(picture.get(), &RasterSource::tilesChanged, this, &PreviewWiring::onTilesChanged, Qt::UniqueConnection);
}

void PreviewWiring::onTilesChanged() {
  if (panel_.view().isVisible()) refresh();
}

QString PreviewWiring::reason() const {
  if (!session_.isReady()) return tr("Load a blueprint and a SLAM map first");
  if (session_.alignment().result()) return {};
  switch (session_.alignment().status()) {
    case AlignmentStatus::kNoAnchors:
      return tr("Nothing to lay over it yet: place an anchor in both views");
    case AlignmentStatus::kFailed:
      return session_.alignment().error() ? toQString(session_.alignment().error()->sentence()) : QString();
    default:
      return tr("Solving...");
  }
}

QString PreviewWiring::notCurrent() const {
  const AlignmentStatus status = session_.alignment().status();
  if (!session_.alignment().result()) return {};
  if (status == AlignmentStatus::kFailed) return tr("Not current: the last solve failed, this is the result before it");
  if (status == AlignmentStatus::kCancelled) return tr("Not current: the last solve was stopped");
  if (session_.alignment().result()->solution.anchors_used == 1)
    return tr("Rough: one anchor says nothing of the turn");
  return {};
}

void PreviewWiring::showBase() {
  const Side side = baseSide();
  const std::optional<MapFrame>& frame = session_.rasters().frame(side);
  // A picture may be there before its frame is.
  const std::shared_ptr<TilePyramid> picture = frame ? session_.rasters().picture(side) : nullptr;
  PreviewView& view = panel_.view();
  if (frame) view.setFrame(*frame);
  if (picture == base_picture_) return;
  base_picture_ = picture;
  view.clearPicture();
  view.setImage(picture);
  if (picture) view.fit();
}

void PreviewWiring::addOtherMaps(PreviewScene& scene, std::vector<InkEntry>& inks) {
  std::size_t number = 1;
  for (const ProjectSlamMap& map : session_.document().project().slam_maps) {
    const auto result = session_.alignment().results().find(map.name);
    if (map.name == session_.document().currentMapName() || result == session_.alignment().results().end()) continue;
    const Result<MapFrame> frame = readMapFrame(map.raster.metadata);
    if (!frame) continue;
    std::shared_ptr<TilePyramid>& picture = other_pictures_[map.raster.metadata.image.string()];
    if (!picture) picture = TilePyramid::load(map.raster.metadata.image, map.raster.metadata.mirrored);
    follow(picture);
    const QColor ink = kMapInks[number++ % kMapInks.size()];
    scene.layers.push_back({{picture->store(), *frame}, result->second->projector, ink});
    inks.push_back({ink, toQString(map.name)});
  }
}

void PreviewWiring::refresh() {
  PreviewView& view = panel_.view();
  stale_ = !view.isVisible();
  if (stale_) return;
  showBase();
  view.setReason(reason());
  view.setNotCurrent(notCurrent());
  const SolveResultPtr& result = session_.alignment().result();
  if (!result || !session_.isReady()) {
    service_.setScene(nullptr);
    view.clearPicture();
    refreshOverlays();
    return;
  }

  const Side below = baseSide();
  const Side above = otherSide(below);
  const bool all = panel_.mode() == PreviewMode::kAllMaps;
  const QString blueprint_name = tr("Blueprint");
  const QString slam_name = toQString(session_.document().currentMapName());
  const auto inkOf = [](Side side) { return side == Side::kBlueprint ? kBlueprintInk : kSlamInk; };
  auto scene = std::make_shared<PreviewScene>();
  scene->direction = below == Side::kBlueprint ? WarpDirection::kToBlueprint : WarpDirection::kToSlam;
  for (const Side side : {below, above}) follow(session_.rasters().picture(side));
  scene->base = {session_.rasters().picture(below)->store(), session_.rasters().frame(below)};
  scene->base_ink = all ? kGreyInk : inkOf(below);
  const QColor ink = all ? kMapInks[0] : inkOf(above);
  scene->layers.push_back(
      {{session_.rasters().picture(above)->store(), session_.rasters().frame(above)}, result->projector, ink});
  std::vector<InkEntry> inks{{scene->base_ink, below == Side::kBlueprint ? blueprint_name : slam_name},
                             {ink, above == Side::kBlueprint ? blueprint_name : slam_name}};
  if (all) {
    addOtherMaps(*scene, inks);
  } else {
    other_pictures_.clear();
  }
  view.setInks(std::move(inks));
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
  view.setResiduals(std::move(residuals), kMagnification);
  if (result && panel_.mode() == PreviewMode::kMesh) {
    const auto mesh = side == Side::kBlueprint ? meshInBlueprint(*result) : meshInSlam(*result);
    view.setFullColorStrain(fullColorStrain(*mesh));
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
