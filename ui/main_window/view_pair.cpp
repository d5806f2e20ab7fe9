// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/main_window/view_pair.h"

#include "ui/convert.h"
#include "ui/document/anchor_commands.h"
#include "ui/main_window/mesh_overlay.h"
#include "ui/main_window/stored_view.h"
#include "ui/models/foreign_text.h"
#include "ui/panels/marker_class.h"

#include <QEvent>
#include <QKeyEvent>

#include <algorithm>
#include <cmath>

namespace cad2slam {
namespace {

constexpr double kRingSigmas = 2.0;  // a ring that the true place rarely leaves

}  // namespace

ViewPair::ViewPair(Session& session, MapView& blueprint, MapView& slam, QObject* parent)
    : QObject(parent), session_(session), blueprint_(blueprint), slam_(slam) {
  connectView(Side::kBlueprint);
  connectView(Side::kSlam);
  connect(&session_.document(), &ProjectDocument::changed, this, [this](const ChangeEvent& event) {
    if (event.what & Change::kEverything) {  // names may be the same in another project
      seen_maps_ = {};
      shown_map_.clear();
      cursor_.reset();
      for (const Side side : {Side::kBlueprint, Side::kSlam}) view(side).setMirroredCursor(std::nullopt);
    }
    blueprint_.setLocked(session_.document().isLocked());
    slam_.setLocked(session_.document().isLocked());
    if (event.what & Change::kPending) {
      ghost_radius_m_.reset();
      ghost_shown_ = false;
      refreshPending();
    }
    refreshMarkers();
  });
  connect(&session_, &Session::judged, this, &ViewPair::refreshMarkers);
  connect(&session_.selection(), &AnchorSelection::changed, this, &ViewPair::refreshMarkers);
  connect(&session_.rasters(), &RasterStore::changed, this, &ViewPair::onRaster);
  connect(&session_.alignment(), &Alignment::resultChanged, this, [this] {
    refreshPending();
    refreshResiduals();
    refreshMesh();
    mirrorCursor();
  });
  connect(&session_.alignment(), &Alignment::sigmaKnown, this, [this](const QPointF&, double sigma_m) {
    if (std::isfinite(sigma_m)) ghost_radius_m_ = kRingSigmas * sigma_m;
    refreshPending();
  });
}

void ViewPair::connectView(Side side) {
  MapView& v = view(side);
  v.installEventFilter(this);
  connect(&v, &MapView::clicked, this, [this, side](const QPointF& point_m, Qt::KeyboardModifiers, bool snapped) {
    onClicked(side, point_m, snapped);
  });
  connect(&v, &MapView::markerPressed, this, [this](MarkerId id, Qt::KeyboardModifiers modifiers) {
    if (!session_.document().anchor(id)) return;
    if (modifiers & (Qt::ControlModifier | Qt::ShiftModifier)) {
      session_.selection().toggle(id);
    } else {
      session_.selection().set({id});
    }
  });
  connect(&v, &MapView::markerDoubleClicked, this, [this](MarkerId id) { centerOn(id); });
  connect(&v, &MapView::markerMenuRequested, this, [this](MarkerId id, const QPoint& global_px) {
    if (session_.flow().cancel()) return;
    if (!session_.document().anchor(id)) return;
    if (!session_.selection().contains(id)) session_.selection().set({id});
    emit anchorMenuRequested(id, global_px);
  });
  connect(&v, &MapView::menuRequested, this, [this, side](const QPointF& point_m, const QPoint& global_px) {
    if (!session_.flow().cancel()) emit menuRequested(side, point_m, global_px);
  });
  connect(&v, &MapView::dragStarted, this, [this, side](MarkerId id) { onDragStarted(side, id); });
  connect(&v, &MapView::dragMoved, this,
          [this, side](MarkerId id, const QPointF& point_m) { onDragMoved(side, id, point_m, true, false); });
  connect(&v, &MapView::dragFinished, this, [this, side](MarkerId id, const QPointF& point_m, bool snapped) {
    onDragMoved(side, id, point_m, false, snapped);
  });
  connect(&v, &MapView::dragCancelled, this, [this, side](MarkerId id) { onDragCancelled(side, id); });
  connect(&v, &MapView::poseTurned, this,
          [this, side](MarkerId id, double heading_rad) { emit poseTurned(side, id, heading_rad); });
  connect(&v, &MapView::poseTurnFinished, this,
          [this, side](MarkerId id, double heading_rad) { emit poseTurned(side, id, heading_rad); });
  connect(&v, &MapView::hoveredMarkerChanged, this,
          [this, side](MarkerId id) { view(otherSide(side)).setHighlighted(id); });
  connect(&v, &MapView::nudged, this,
          [this, side](const QPointF& delta_m, int burst) { onNudged(side, delta_m, burst); });
  connect(&v, &MapView::acceptRequested, this, [this] { session_.flow().acceptPrediction(); });
  connect(&v, &MapView::cancelRequested, this, &ViewPair::cancelOrDeselect);
  connect(&v, &MapView::deleteRequested, this, &ViewPair::deleteRequested);
  connect(&v, &MapView::cursorMoved, this, [this, side](const QPointF& point_m, const QPointF& image_px) {
    emit cursorMoved(side, point_m, image_px);
    cursor_ = Cursor{side, point_m};
    mirrorCursor();
  });
  connect(&v, &MapView::cursorLeft, this, [this, side] {
    if (cursor_ && cursor_->side == side) cursor_.reset();
    view(otherSide(side)).setMirroredCursor(std::nullopt);
    emit cursorLeft();
  });
  connect(&v, &MapView::viewStateChanged, this, [this, side] { link(side); });
  connect(&v, &MapView::loupeChanged, this, [this, side](bool on) { view(otherSide(side)).setLoupe(on); });
  // Keys go to the view that has the focus, and that is not the one under the mouse after a first click.
  connect(&v, &MapView::loupeHeld, this, [this, side](bool held) { view(otherSide(side)).setLoupeHeld(held); });
  connect(&v, &MapView::filesDropped, this, [this, side](const QStringList& paths) { emit filesDropped(side, paths); });
}

void ViewPair::mirrorCursor() {
  if (!cursor_) return;
  const std::optional<CarriedPoint> there = session_.carry(cursor_->side, cursor_->point_m);
  view(otherSide(cursor_->side))
      .setMirroredCursor(there ? std::optional(there->point_m) : std::nullopt, there && there->certain);
}

void ViewPair::cancelOrDeselect() {
  if (!session_.flow().cancel()) session_.selection().clear();
}

bool ViewPair::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::FocusIn) active_ = watched == &blueprint_ ? Side::kBlueprint : Side::kSlam;
  if (event->type() == QEvent::KeyPress) {
    // With an anchor selected Tab changes which half the arrow keys move; F6 goes on to the other parts of the window.
    const auto* key = static_cast<QKeyEvent*>(event);
    if (key->key() == Qt::Key_Tab && session_.selection().current()) {
      view(otherSide(active_)).setFocus(Qt::TabFocusReason);
      return true;
    }
  }
  return QObject::eventFilter(watched, event);
}

void ViewPair::onClicked(Side side, const QPointF& point_m, bool snapped) {
  if (!session_.isReady()) return;
  session_.flow().click(side, point_m, snapped);
}

bool ViewPair::isPendingMarker(MarkerId id) const {
  return session_.flow().half() && id == session_.document().nextId();
}

void ViewPair::onDragStarted(Side side, MarkerId id) {
  gesture_ = session_.document().newGesture();
  if (const Anchor* anchor = session_.document().anchor(id)) drag_start_m_ = toQPointF(half(*anchor, side));
  drag_start_snapped_ = session_.document().isSnapped(id);
  if (const auto pending = session_.flow().half(); pending && isPendingMarker(id)) {
    drag_start_m_ = pending->point_m;
    drag_start_snapped_ = pending->snapped;
  }
}

void ViewPair::onDragMoved(Side side, MarkerId id, const QPointF& point_m, bool interim, bool snapped) {
  if (isPendingMarker(id)) return session_.flow().click(side, point_m, snapped);
  if (session_.document().anchor(id)) {
    edit::moveAnchor(session_.document(), id, side, toEigen(point_m), gesture_, interim, snapped);
  } else {
    emit poseDragged(side, id, point_m, interim);
  }
}

void ViewPair::onDragCancelled(Side side, MarkerId id) {
  onDragMoved(side, id, drag_start_m_, false, drag_start_snapped_);
}

void ViewPair::onNudged(Side side, const QPointF& delta_m, int burst) {
  const std::optional<AnchorId> id = session_.selection().current();
  const Anchor* anchor = id ? session_.document().anchor(*id) : nullptr;
  if (!anchor || session_.document().isLocked()) return;
  if (burst_.side != side || burst_.id != *id || burst_.number != burst) gesture_ = session_.document().newGesture();
  burst_ = {side, *id, burst};
  edit::moveAnchor(session_.document(), *id, side, half(*anchor, side) + toEigen(delta_m), gesture_);
}

void ViewPair::onRaster(Side side, bool new_picture) {
  MapView& v = view(side);
  const std::optional<MapFrame>& frame = session_.rasters().frame(side);
  if (frame && !new_picture) v.reframe(*frame);
  if (new_picture) {
    if (side == Side::kSlam) rememberMap();
    if (frame) v.setFrame(*frame);
    v.setImage(frame ? session_.rasters().picture(side) : nullptr);
    if (frame) v.fit();
  }
  if (frame && side == Side::kSlam) {
    shown_map_ = session_.document().currentMapName();
    if (new_picture) restoreView(v, seen_maps_.value(toQString(shown_map_)).toObject());
  }
  refreshMarkers();
}

void ViewPair::rememberMap() {
  if (!shown_map_.empty()) seen_maps_.insert(toQString(shown_map_), storedView(slam_));
  shown_map_.clear();
}

QJsonObject ViewPair::seenMaps() {
  QJsonObject seen;
  for (const ProjectSlamMap& map : session_.document().project().slam_maps) {
    const QString name = toQString(map.name);
    if (map.name == shown_map_) {
      seen.insert(name, storedView(slam_));
    } else if (seen_maps_.contains(name)) {
      seen.insert(name, seen_maps_.value(name));
    }
  }
  return seen;
}

std::vector<Marker> ViewPair::markersOf(Side side) const {
  std::vector<Marker> markers;
  ProjectDocument& document = session_.document();
  for (const Anchor& anchor : document.anchors()) {
    Marker marker;
    marker.id = anchor.id;
    marker.text = QString::number(anchor.id);
    if (!anchor.name.empty()) marker.text += QLatin1Char(' ') + shortened(toQString(anchor.name));
    marker.point_m = toQPointF(half(anchor, side));
    const auto judgement = session_.judgements().find(anchor.id);
    if (judgement != session_.judgements().end()) marker.judged = markerClass(judgement->second.judged);
    if (!anchor.enabled) marker.judged = MarkerClass::kDisabled;
    marker.selected = session_.selection().contains(anchor.id);
    marker.snapped = document.isSnapped(anchor.id);
    markers.push_back(std::move(marker));
  }
  if (const auto pending = session_.flow().half(); pending && pending->side == side) {
    Marker marker;
    marker.id = document.nextId();
    marker.text = QString::number(document.nextId());
    marker.point_m = pending->point_m;
    marker.judged = MarkerClass::kPending;
    marker.snapped = pending->snapped;
    markers.push_back(std::move(marker));
  }
  return markers;
}

void ViewPair::refreshMarkers() {
  blueprint_.setMarkers(markersOf(Side::kBlueprint));
  slam_.setMarkers(markersOf(Side::kSlam));
  refreshResiduals();
}

void ViewPair::refreshPending() {
  const auto pending = session_.flow().half();
  for (const Side side : {Side::kBlueprint, Side::kSlam}) {
    MapView& v = view(side);
    const bool due = pending && pending->side != side;
    const bool predicted = due && session_.flow().prediction();
    v.setAttention(!due        ? QString()
                   : predicted ? tr("Click the same place here (Enter accepts, Esc cancels)")
                               : tr("Now click the same place here (Esc cancels)"),
                   due);
    if (!due || !session_.flow().prediction()) {
      v.setGhost(std::nullopt);
      continue;
    }
    const QPointF expected = *session_.flow().prediction();
    // What the anchors were off by when they were predicted themselves; the model alone thinks too well of itself.
    const double seen =
        session_.summary().median_leave_one_out_m.value_or(session_.summary().max_residual_m.value_or(0.0));
    v.setGhost(Ghost{expected, std::max(ghost_radius_m_.value_or(0.0), kRingSigmas * seen),
                     tr("%1? Enter accepts").arg(session_.document().nextId())});
    // Once for each half, and never the zoom: the installer's view is theirs.
    if (!ghost_shown_ && !v.isInView(expected)) v.centerOn(expected, true);
    ghost_shown_ = true;
  }
}

void ViewPair::refreshResiduals() {
  std::vector<ResidualVector> in_slam;
  const SolveResultPtr& result = session_.alignment().result();
  if (result && residuals_visible_) {
    for (const AnchorFit& fit : result->solution.anchors) {
      const Anchor* anchor = session_.document().anchor(fit.id);
      if (!anchor || !fit.predicted.allFinite()) continue;
      const auto judgement = session_.judgements().find(fit.id);
      in_slam.push_back(
          {toQPointF(fit.predicted), toQPointF(anchor->in_slam),
           judgement == session_.judgements().end() ? MarkerClass::kPlain : markerClass(judgement->second.judged)});
    }
  }
  slam_.setResiduals(std::move(in_slam), magnification_);
}

void ViewPair::refreshMesh() {
  const SolveResultPtr& result = session_.alignment().result();
  const bool show = mesh_visible_ && result;
  slam_.setMesh(show ? meshInSlam(*result) : nullptr);
  blueprint_.setMesh(show ? meshInBlueprint(*result) : nullptr);
}

void ViewPair::setMagnification(double factor) {
  magnification_ = factor;
  refreshResiduals();
}

void ViewPair::setResidualsVisible(bool visible) {
  residuals_visible_ = visible;
  refreshResiduals();
}

void ViewPair::setMeshVisible(bool visible) {
  mesh_visible_ = visible;
  refreshMesh();
}

void ViewPair::centerOn(AnchorId id) {
  const Anchor* anchor = session_.document().anchor(id);
  if (!anchor) return;
  blueprint_.centerOn(toQPointF(anchor->in_blueprint), true);
  slam_.centerOn(toQPointF(anchor->in_slam), true);
}

void ViewPair::centerOnPlace(Side side, const QPointF& point_m) {
  view(side).centerOn(point_m, true);
  if (const auto there = session_.carry(side, point_m)) view(otherSide(side)).centerOn(there->point_m, true);
}

void ViewPair::bringIntoView(Side side, const QPointF& point_m) {
  if (!view(side).isInView(point_m)) view(side).centerOn(point_m, true);
}

void ViewPair::setLinked(bool linked) {
  if (linked == linked_) return;
  linked_ = linked;
  emit linkedChanged(linked);
  if (linked_) follow(active_);
}

void ViewPair::follow(Side leader) {
  if (linking_) return;
  const ViewState state = view(leader).viewState();
  const std::optional<CarriedPoint> there = session_.carry(leader, state.center_m);
  if (!there) return;
  linking_ = true;
  view(otherSide(leader))
      .setViewState({there->point_m, state.m_per_px * there->scale, state.rotation_rad - there->turn_rad});
  linking_ = false;
}

void ViewPair::link(Side leader) {
  // The follower answers with its own change; the leader of the moment is the one not being set.
  if (linked_ && !linking_) follow(leader);
}

}  // namespace cad2slam
