// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <QLocale>
#include <QPaintEvent>
#include <QPainterPath>

#include "ui/views/label_layout.h"
#include "ui/views/map_decorations.h"
#include "ui/views/map_view.h"

namespace cad2slam {
namespace {

constexpr double kLoupeRadius_px = 78.0;
constexpr double kLoupeZoom = 4.0;

// Nearer to each other, markers of normal size hide each other, and markers with their numbers the map between them.
constexpr double kMarkersCrowd_px = 14.0;
constexpr double kMapIsHidden_px = 60.0;

/// Whether a good part of the places are closer than that to another one.
bool isCrowd(std::vector<QPointF> by_x, double too_close_px) {
  std::sort(by_x.begin(), by_x.end(), [](const QPointF& a, const QPointF& b) { return a.x() < b.x(); });
  std::vector<bool> hidden(by_x.size(), false);
  for (std::size_t i = 0; i < by_x.size(); ++i)
    for (std::size_t j = i + 1; j < by_x.size() && by_x[j].x() - by_x[i].x() < too_close_px; ++j)
      if (std::abs(by_x[j].y() - by_x[i].y()) < too_close_px) hidden[i] = hidden[j] = true;
  return 2 * std::count(hidden.begin(), hidden.end(), true) > static_cast<std::ptrdiff_t>(by_x.size());
}

int urgencyOf(MarkerClass judged) {
  switch (judged) {
    case MarkerClass::kDisabled:
      return 0;
    case MarkerClass::kPlain:
    case MarkerClass::kOk:
      return 1;
    case MarkerClass::kLook:
      return 2;
    case MarkerClass::kBad:
      return 3;
    case MarkerClass::kPending:
      break;
  }
  return 4;
}

}  // namespace

QColor MapView::backgroundColor() const {
  return palette().color(QPalette::Mid);
}

void MapView::paintBase(QPainter& painter) {
  raster_.paint(painter, widgetFromImage(), size(), backgroundColor());
}

void MapView::paintOnTop(QPainter&) {}

void MapView::paintOverlays(QPainter& painter, const QTransform& widget_from_metres, double px_per_m) {
  for (const PathGlyph& path : paths_) marker_painter_.paintPath(painter, path, widget_from_metres);
  paintResiduals(painter, widget_from_metres, false);
  paintPoses(painter, widget_from_metres, px_per_m, false);
  if (markers_visible_) paintMarkers(painter, widget_from_metres);
  paintResiduals(painter, widget_from_metres, true);
  for (const PathGlyph& path : paths_) marker_painter_.paintPathText(painter, path, widget_from_metres);
  paintPoses(painter, widget_from_metres, px_per_m, true);
  if (ghost_) {  // over other anchors: it is what the next key or click is about
    marker_painter_.paintGhost(painter, widget_from_metres.map(ghost_->point_m), ghost_->radius_m * px_per_m,
                               ghost_->text, width());
  }
  if (mirrored_cursor_m_) {
    marker_painter_.paintMirroredCursor(painter, widget_from_metres.map(*mirrored_cursor_m_), mirrored_certain_);
  }
}

double MapView::residualMagnification() const {
  if (residual_magnification_ != kAutomaticMagnification) return residual_magnification_;
  constexpr double kLongest = 0.14;  // of the view, before the factor is rounded down
  constexpr double kMost = 1000.0;   // what is exact but for rounding shall look so
  double longest_m = 0.0;
  for (const ResidualVector& residual : residuals_) {
    const QPointF way = residual.clicked_m - residual.projected_m;
    const double length = std::hypot(way.x(), way.y());
    if (std::isfinite(length)) longest_m = std::max(longest_m, length);
  }
  if (!(longest_m > 0.0)) return 1.0;
  const double room_m = kLongest * (width() + height()) / 2.0 * state_.m_per_px;
  return std::clamp(decoration::roundedDown(room_m / longest_m), 1.0, kMost);
}

void MapView::paintResiduals(QPainter& painter, const QTransform& widget_from_metres, bool over_markers) {
  constexpr double kHidden_px = 12.0;  // below a marker; what it hides in turn is the place that was clicked
  const double magnification = residualMagnification();
  for (const ResidualVector& residual : residuals_) {
    const QPointF from = widget_from_metres.map(residual.projected_m);
    const QPointF way = (widget_from_metres.map(residual.clicked_m) - from) * magnification;
    const bool over = dots_ || std::hypot(way.x(), way.y()) > kHidden_px;
    if (over == over_markers) marker_painter_.paintResidual(painter, from, from + way, residual.judged);
  }
}

void MapView::paintPoses(QPainter& painter, const QTransform& widget_from_metres, double px_per_m, bool to_drag) {
  constexpr std::size_t kMany = 300;    // of which no more than their way can be seen
  constexpr double kBeside_px = 120.0;  // handle and text
  const bool many = poses_.size() > kMany;
  for (const PoseGlyph& pose : poses_) {
    if ((pose.id != kNoMarker) != to_drag) continue;
    const QPointF at = widget_from_metres.map(pose.point_m);
    const double reach = kBeside_px + pose.radius_m * px_per_m;
    if (!QRectF(rect()).adjusted(-reach, -reach, reach, reach).contains(at)) continue;
    const double on_screen = -(pose.heading_rad + state_.rotation_rad);
    if (many && pose.id == kNoMarker) {
      marker_painter_.paintPoseTick(painter, pose, at, on_screen);
      continue;
    }
    const bool enlarged = pose.id != kNoMarker && (pose.id == hovered_ || pose.id == highlighted_);
    marker_painter_.paintPose(painter, pose, at, on_screen, pose.radius_m * px_per_m, enlarged);
  }
}

std::vector<MapView::SeenMarker> MapView::seenMarkers(const QTransform& widget_from_metres) const {
  std::vector<SeenMarker> seen;
  std::vector<QPointF> places;
  const QRectF view = QRectF(rect()).adjusted(-80, -40, 80, 40);
  for (const Marker& marker : markers_) {
    const QPointF at = widget_from_metres.map(marker.point_m);
    if (!view.contains(at)) continue;
    const bool enlarged = marker.id == hovered_ || marker.id == highlighted_;
    seen.push_back({&marker, at, enlarged ? MarkerSize::kEnlarged : MarkerSize::kNormal, enlarged || marker.selected});
    places.push_back(at);
  }
  if (dots_ || isCrowd(std::move(places), map_first_ ? kMapIsHidden_px : kMarkersCrowd_px)) {
    for (SeenMarker& each : seen)
      if (!each.in_front) each.size = dots_ || map_first_ ? MarkerSize::kDot : MarkerSize::kSmall;
  }
  // Where they cover each other, what needs a look is in front.
  const auto weight = [](const SeenMarker& each) { return std::pair(each.in_front, urgencyOf(each.marker->judged)); };
  std::stable_sort(seen.begin(), seen.end(),
                   [&](const SeenMarker& a, const SeenMarker& b) { return weight(a) < weight(b); });
  return seen;
}

void MapView::paintMarkers(QPainter& painter, const QTransform& widget_from_metres) {
  const std::vector<SeenMarker> seen = seenMarkers(widget_from_metres);
  for (const SeenMarker& each : seen) marker_painter_.paintMarker(painter, *each.marker, each.at, each.size);
  if (!marker_text_visible_) return;
  LabelLayout layout(size());
  layout.occupy(decoration::compassRect(size()));
  layout.occupy(legend_rect_);
  for (const SeenMarker& each : seen) layout.occupy(MarkerPainter::coreOf(each.at, each.size));
  for (auto each = seen.rbegin(); each != seen.rend(); ++each) {
    if (each->size == MarkerSize::kDot) continue;  // the map matters more
    const QSizeF text = marker_painter_.textSize(painter, *each->marker);
    const double reach = MarkerPainter::labelReach(*each->marker, each->size);
    std::optional<QRectF> area = layout.place(each->at, reach, text);
    if (!area && each->in_front) area = layout.placeAnyway(each->at, reach, text);
    if (area) marker_painter_.paintLabel(painter, *each->marker, *area);
  }
}

std::optional<PreviewLegend> MapView::legend() const {
  if (mesh_.isEmpty()) return std::nullopt;
  return PreviewLegend::ofMesh(mesh_full_color_);
}

void MapView::paintLegend(QPainter& painter) {
  constexpr double kGivesWay = 0.12;
  constexpr int kSmallView_px = 300;  // where the map matters more
  constexpr double kSmaller = 0.85;
  constexpr double kEdge_px = 8.0;
  legend_rect_ = QRectF();
  std::optional<PreviewLegend> shown = legend();
  if (!shown) return;
  QFont font = painter.font();
  if (height() < kSmallView_px) {
    shown->hint.clear();
    font.setPointSizeF(kSmaller * font.pointSizeF());
  }
  const QPixmap picture = shown->picture(font, width() - 2.0 * kEdge_px, painter.device()->devicePixelRatioF());
  const QSizeF area = picture.deviceIndependentSize();
  legend_rect_ = QRectF(QPointF(width() - area.width() - kEdge_px, height() - area.height() - kEdge_px), area);
  painter.save();
  if (cursor_ && legend_rect_.contains(*cursor_)) painter.setOpacity(kGivesWay);
  painter.drawPixmap(legend_rect_.topLeft(), picture);
  painter.restore();
}

void MapView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  if (!paint_turn_.take(painter)) return;
  const QSizeF view = size();
  const bool has_image = raster_.source() != nullptr && frame_.has_value();
  if (!has_image) {
    painter.fillRect(rect(), palette().color(QPalette::Window));
    using decoration::EmptyLook;
    decoration::paintEmpty(painter, view, empty_text_, palette(),
                           drop_hover_     ? EmptyLook::kDropHover
                           : acceptDrops() ? EmptyLook::kDropZone
                                           : EmptyLook::kText);
    if (hasFocus()) decoration::paintFocus(painter, view, palette().color(QPalette::Highlight));
    raster_.reserve((view * devicePixelRatioF()).toSize());
    marker_painter_.prepare(painter);
    return;
  }

  paintBase(painter);
  mesh_.paint(painter, state_, size());
  paintOverlays(painter, widget_from_metres_, 1.0 / state_.m_per_px);
  const bool loupe = loupe_on_ || loupe_held_ || long_pressed_;
  if (snap_m_ && cursor_) marker_painter_.paintSnap(painter, widgetFromMetres(*snap_m_));
  if (moved_by_keys_ && hasFocus()) {
    decoration::paintCrosshair(painter, view, QRectF(rect()).center());
  } else if (cursor_ && (crosshair_ || loupe)) {
    decoration::paintCrosshair(painter, view, *cursor_);
  }

  decoration::paintScaleBar(painter, view, state_.m_per_px * scale_bar_unit_m_);
  decoration::paintCompass(painter, view, state_.rotation_rad, compass_hovered_ || gesture_ == Gesture::kTurnView);
  paintOnTop(painter);
  paintLegend(painter);
  if (cursor_ && loupe) paintLoupe(painter);

  constexpr int kLongRead_ms = 700;
  if (const int percent = raster_.source()->percentRead(); percent < 100 && image_since_.elapsed() > kLongRead_ms) {
    decoration::paintChip(painter, QPointF(view.width() / 2.0, view.height() - 62.0),
                          tr("Reading the image, %1 %").arg(percent), QColor(50, 54, 60, 215), view.width() * 0.5);
  }
  if (magnification_note_ && !residuals_.empty() && residualMagnification() != 1.0) {
    const QString text =
        tr("Residuals drawn %1 times as long").arg(QLocale().toString(residualMagnification(), 'g', 3));
    decoration::paintChip(painter, QPointF(view.width() / 2.0, view.height() - 36.0), text, QColor(50, 54, 60, 215),
                          view.width() * 0.5);
  }
  if (framed_) decoration::paintAttentionFrame(painter, view, decoration::attentionColor());
  if (!chip_text_.isEmpty()) {
    const QColor color = framed_ ? decoration::attentionColor() : QColor(50, 54, 60, 215);
    decoration::paintChip(painter, QPointF(view.width() / 2.0, 10.0), chip_text_, color, view.width() - 110.0);
  }
  if (hasFocus() && !framed_) decoration::paintFocus(painter, view, palette().color(QPalette::Highlight));
}

void MapView::paintLoupe(QPainter& painter) {
  const QPointF at = *cursor_;
  const double side = 2.0 * kLoupeRadius_px;
  const QPointF corner = at - QPointF(kLoupeRadius_px, kLoupeRadius_px);
  // Enlarged about the cursor, then moved so that the cursor lies in the middle of the loupe.
  const QTransform enlarged = QTransform::fromTranslate(-at.x(), -at.y()) *
                              QTransform::fromScale(kLoupeZoom, kLoupeZoom) *
                              QTransform::fromTranslate(kLoupeRadius_px, kLoupeRadius_px);
  QPainterPath lens;
  lens.addEllipse(at, kLoupeRadius_px, kLoupeRadius_px);
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setClipPath(lens);
  painter.translate(corner);
  loupe_raster_.paint(painter, widgetFromImage() * enlarged, QSize(static_cast<int>(side), static_cast<int>(side)),
                      backgroundColor());
  if (markers_visible_) {
    for (const Marker& marker : markers_) {
      const QPointF place = enlarged.map(widgetFromMetres(marker.point_m));
      if (QRectF(-20, -20, side + 40, side + 40).contains(place)) {
        marker_painter_.paintMarker(painter, marker, place, MarkerSize::kNormal);
        if (marker_text_visible_) marker_painter_.paintLabel(painter, marker, place);
      }
    }
  }
  if (snap_m_) marker_painter_.paintSnap(painter, enlarged.map(widgetFromMetres(*snap_m_)));
  decoration::paintCrosshair(painter, QSizeF(side, side), QPointF(kLoupeRadius_px, kLoupeRadius_px));
  painter.restore();
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.strokePath(lens, QPen(Qt::white, 5.0));
  painter.strokePath(lens, QPen(QColor(40, 44, 50), 2.5));
  painter.restore();
}

}  // namespace cad2slam
