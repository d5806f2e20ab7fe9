// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/main_window/session.h"
#include "ui/views/map_view.h"

#include <QJsonObject>
#include <QObject>

#include <optional>
#include <string>

namespace cad2slam {

/// The two views and how they play together: markers and the predicted counterpart, clicks and drags as edits, the
/// mirrored cursor, linked views.
class ViewPair : public QObject {
  Q_OBJECT

 public:
  /// The views belong to whoever lays them out.
  ViewPair(Session& session, MapView& blueprint, MapView& slam, QObject* parent = nullptr);

  [[nodiscard]] MapView& view(Side side) { return side == Side::kBlueprint ? blueprint_ : slam_; }
  /// The view that has the focus, or had it last.
  [[nodiscard]] Side activeSide() const { return active_; }
  [[nodiscard]] MapView& activeView() { return view(active_); }

  [[nodiscard]] bool areLinked() const { return linked_; }
  void setLinked(bool linked);
  /// One view shows what the other shows.
  void follow(Side leader);
  /// Shows an anchor in the middle of both views, at the zoom they have.
  void centerOn(AnchorId id);
  void centerOnPlace(Side side, const QPointF& point_m);
  /// Only where it is not there yet.
  void bringIntoView(Side side, const QPointF& point_m);
  /// What part of each SLAM map is seen, or was when it was last shown; by name.
  [[nodiscard]] QJsonObject seenMaps();
  void setSeenMaps(const QJsonObject& seen) { seen_maps_ = seen; }
  void setMagnification(double factor);
  [[nodiscard]] double magnification() const { return magnification_; }
  void setResidualsVisible(bool visible);
  void setMeshVisible(bool visible);

  /// Esc: drops a half anchor, or else the selection.
  void cancelOrDeselect();

 signals:
  void linkedChanged(bool linked);
  /// Cursor in a view, for the read-out; empty when it left.
  void cursorMoved(cad2slam::Side side, const QPointF& point_m, const QPointF& image_px);
  void cursorLeft();
  void anchorMenuRequested(cad2slam::AnchorId id, const QPoint& global_px);
  void menuRequested(cad2slam::Side side, const QPointF& point_m, const QPoint& global_px);
  void deleteRequested();
  void filesDropped(cad2slam::Side side, const QStringList& paths);
  void poseDragged(cad2slam::Side side, cad2slam::MarkerId id, const QPointF& point_m, bool interim);
  void poseTurned(cad2slam::Side side, cad2slam::MarkerId id, double heading_rad);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void connectView(Side side);
  void onClicked(Side side, const QPointF& point_m, bool snapped);
  void onDragStarted(Side side, MarkerId id);
  void onDragMoved(Side side, MarkerId id, const QPointF& point_m, bool interim, bool snapped);
  void onDragCancelled(Side side, MarkerId id);
  void onNudged(Side side, const QPointF& delta_m, int burst);
  void onRaster(Side side, bool new_picture);
  void rememberMap();
  void refreshMarkers();
  void refreshPending();
  void refreshResiduals();
  void refreshMesh();
  void link(Side leader);
  void mirrorCursor();
  [[nodiscard]] std::vector<Marker> markersOf(Side side) const;
  [[nodiscard]] bool isPendingMarker(MarkerId id) const;

  Session& session_;
  MapView& blueprint_;
  MapView& slam_;
  Side active_ = Side::kBlueprint;
  bool linked_ = false;
  bool linking_ = false;
  bool residuals_visible_ = true;
  bool mesh_visible_ = false;
  double magnification_ = 1.0;
  std::optional<double> ghost_radius_m_;
  bool ghost_shown_ = false;
  struct Cursor {
    Side side;
    QPointF point_m;
  };
  std::optional<Cursor> cursor_;  // while it is over a view

  QJsonObject seen_maps_;
  std::string shown_map_;  // empty: none
  int gesture_ = 0;
  QPointF drag_start_m_;
  bool drag_start_snapped_ = false;
  struct Burst {
    Side side = Side::kBlueprint;
    AnchorId id = -1;
    int number = -1;
  } burst_;
};

}  // namespace cad2slam
