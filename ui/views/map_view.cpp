// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/views/map_view.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QApplication>
#include <QCursor>
#include <QResizeEvent>

#include "cad2slam/anchors/anchor.h"
#include "ui/convert.h"

namespace cad2slam {
namespace {

constexpr int kMessages_px = 130;  // as high as the messages above the views get
constexpr double kFitMargin = 0.04;
constexpr double kHalfMarker_px = 13.0;    // at the edge of a map it is seen whole
constexpr double kLargestPixel_px = 96.0;  // an image pixel is never drawn larger
constexpr double kSmallestImage_px = 40.0;
constexpr int kGlide_ms = 220;
constexpr int kLongPress_ms = 550;
constexpr double kClickReach_px = 4.0;

/// Files can hold any number, and pixels are counted in whole numbers.
bool isUsable(const ViewState& state) {
  return std::abs(state.center_m.x()) <= kLargestCoordinate && std::abs(state.center_m.y()) <= kLargestCoordinate &&
         std::isfinite(state.m_per_px) && state.m_per_px > 0.0 && std::isfinite(state.rotation_rad);
}

}  // namespace

MapView::MapView(QWidget* parent) : QWidget(parent), mesh_([this] { update(); }) {
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setAcceptDrops(true);
  setAttribute(Qt::WA_OpaquePaintEvent);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  setAccessibleName(tr("Map view"));
  long_press_.setSingleShot(true);
  long_press_.setInterval(kLongPress_ms);
  connect(&long_press_, &QTimer::timeout, this, [this] {
    long_pressed_ = gesture_ == Gesture::kPressed;
    update();
  });
  animation_.setDuration(kGlide_ms);
  animation_.setEasingCurve(QEasingCurve::OutCubic);
  connect(&animation_, &QVariantAnimation::valueChanged, this, [this](const QVariant& value) {
    ViewState state = state_;
    state.center_m = value.toPointF();
    changeState(state);
  });
}

MapView::~MapView() {
  disconnect(image_connection_);
}

void MapView::setImage(std::shared_ptr<RasterSource> image) {
  disconnect(image_connection_);
  raster_.setSource(image);
  loupe_raster_.setSource(image);
  image_since_.start();
  if (image) {
    image_connection_ = connect(image.get(), &RasterSource::tilesChanged, this, [this] {
      raster_.refresh();
      loupe_raster_.refresh();
      update();
    });
  } else {
    gesture_ = Gesture::kNone;
    snap_m_.reset();
  }
  update();
}

void MapView::setFrame(const MapFrame& frame) {
  frame_ = frame;
  updateTransform();
  update();
}

void MapView::reframe(const MapFrame& frame) {
  if (!frame_) return setFrame(frame);
  const MapFrame before = *frame_;
  const Pose2& corner = frame.metricFromCorner();
  if (frame.resolution() == before.resolution() && corner.translation == before.metricFromCorner().translation &&
      corner.heading == before.metricFromCorner().heading)
    return;  // nothing that moves, or was moved by hand, is disturbed
  setFrame(frame);
  if (fitted_) return fit();
  const Eigen::Vector2d middle_px = before.pixelFromMetric(toEigen(state_.center_m));
  setViewState({toQPointF(frame.metricFromPixel(middle_px)), state_.m_per_px * frame.resolution() / before.resolution(),
                state_.rotation_rad - (corner.heading - before.metricFromCorner().heading)});
}

const std::optional<MapFrame>& MapView::frame() const {
  return frame_;
}

void MapView::setEmptyText(const QString& text) {
  empty_text_ = text;
  update();
}

void MapView::setScaleBarUnit(double metres) {
  scale_bar_unit_m_ = metres;
  update();
}

void MapView::setMagnificationNote(bool shown) {
  magnification_note_ = shown;
  update();
}

void MapView::setMarkers(std::vector<Marker> markers) {
  markers_ = std::move(markers);
  update();
}
void MapView::setMarkersVisible(bool visible) {
  markers_visible_ = visible;
  update();
}
void MapView::setMarkerTextVisible(bool visible) {
  marker_text_visible_ = visible;
  update();
}
void MapView::setMapFirst(bool on) {
  map_first_ = on;
  update();
}
void MapView::setMarkersAsDots(bool on) {
  dots_ = on;
  update();
}
void MapView::setGhost(std::optional<Ghost> ghost) {
  ghost_ = std::move(ghost);
  update();
}
void MapView::setResiduals(std::vector<ResidualVector> residuals, double magnification) {
  residuals_ = std::move(residuals);
  residual_magnification_ = magnification;
  update();
}
void MapView::setMesh(std::shared_ptr<const MeshOverlay> mesh) {
  mesh_full_color_ = mesh ? fullColorStrain(*mesh) : kUsualStrain;
  mesh_.setMesh(std::move(mesh));
  update();
}
void MapView::setPoses(std::vector<PoseGlyph> poses) {
  poses_ = std::move(poses);
  update();
}
void MapView::setPaths(std::vector<PathGlyph> paths) {
  paths_ = std::move(paths);
  update();
}
void MapView::setMirroredCursor(std::optional<QPointF> point_m, bool certain) {
  if (!point_m && !mirrored_cursor_m_) return;
  mirrored_cursor_m_ = point_m;
  mirrored_certain_ = certain;
  update();
}
void MapView::setHighlighted(MarkerId id) {
  if (highlighted_ == id) return;
  highlighted_ = id;
  update();
}
void MapView::setAttention(const QString& chip_text, bool framed) {
  if (chip_text_ == chip_text && framed_ == framed) return;
  chip_text_ = chip_text;
  framed_ = framed;
  update();
}

void MapView::setLocked(bool locked) {
  locked_ = locked;
}
void MapView::setSnapping(bool on) {
  snapping_ = on;
  if (!on) snap_m_.reset();
  update();
}
bool MapView::isSnapping() const {
  return snapping_;
}
void MapView::setCrosshair(bool on) {
  crosshair_ = on;
  update();
}
void MapView::setLoupe(bool on) {
  if (loupe_on_ == on) return;
  loupe_on_ = on;
  update();
  emit loupeChanged(on);
}
bool MapView::isLoupeOn() const {
  return loupe_on_;
}
void MapView::setLoupeHeld(bool held) {
  if (loupe_held_ == held) return;
  loupe_held_ = held;
  update();
}
bool MapView::isDragging() const {
  return gesture_ == Gesture::kDragMarker || gesture_ == Gesture::kTurnPose;
}

ViewState MapView::viewState() const {
  return state_;
}

void MapView::setViewState(const ViewState& state) {
  if (!isUsable(state)) return;
  stopAnimation();
  fitted_ = false;
  changeState(state);
}

double MapView::clampedResolution(double m_per_px) const {
  if (!frame_) return std::clamp(m_per_px, 1e-6, 1e6);
  const double finest = frame_->resolution() / kLargestPixel_px;
  const double coarsest = frame_->resolution() * std::max(frame_->width(), frame_->height()) / kSmallestImage_px;
  return std::clamp(m_per_px, finest, std::max(finest, coarsest));
}

void MapView::changeState(const ViewState& state) {
  if (!isUsable(state)) return;
  ViewState next = state;
  next.m_per_px = clampedResolution(state.m_per_px);
  next.rotation_rad = wrapAngle(state.rotation_rad);
  if (next == state_) return;
  state_ = next;
  updateTransform();
  if (cursor_) findSnap(*cursor_, Qt::NoModifier);
  update();
  emit viewStateChanged();
}

void MapView::updateTransform() {
  widget_from_metres_ = state_.widgetFromMetres(size());
  metres_from_widget_ = widget_from_metres_.inverted();
}

QTransform MapView::widgetFromImage() const {
  if (!frame_) return {};
  const QPointF origin = toQPointF(frame_->metricFromPixel({0.0, 0.0}));
  const QPointF column = toQPointF(frame_->metricFromPixel({1.0, 0.0})) - origin;
  const QPointF row = toQPointF(frame_->metricFromPixel({0.0, 1.0})) - origin;
  const QTransform metres_from_image(column.x(), column.y(), row.x(), row.y(), origin.x(), origin.y());
  return metres_from_image * widget_from_metres_;
}

QPointF MapView::metresFromWidget(const QPointF& widget_px) const {
  return metres_from_widget_.map(widget_px);
}
QPointF MapView::widgetFromMetres(const QPointF& point_m) const {
  return widget_from_metres_.map(point_m);
}
QPointF MapView::imagePixelFromMetres(const QPointF& point_m) const {
  return frame_ ? toQPointF(frame_->pixelFromMetric(toEigen(point_m))) : QPointF();
}

void MapView::fit() {
  if (!frame_) return;
  fitted_ = true;
  // The raster's own corners, not the box around them, so that a turned raster fills the view as well.
  stopAnimation();
  const QPointF center = toQPointF(frame_->metricFromPixel({frame_->width() / 2.0, frame_->height() / 2.0}));
  const double turn = frame_->metricFromCorner().heading + state_.rotation_rad;
  const double across = frame_->width() * frame_->resolution();
  const double up = frame_->height() * frame_->resolution();
  const double seen_width = std::abs(across * std::cos(turn)) + std::abs(up * std::sin(turn));
  const double seen_height = std::abs(across * std::sin(turn)) + std::abs(up * std::cos(turn));
  const auto room = [](int side) {
    return std::max(1.0, side - 2.0 * std::max(kFitMargin * side, std::min(kHalfMarker_px, 0.1 * side)));
  };
  const double m_per_px = std::max(seen_width / room(width()), seen_height / room(height()));
  changeState({center, m_per_px, state_.rotation_rad});
}

void MapView::fitRect(const QRectF& area_m, double margin) {
  const double c = std::abs(std::cos(state_.rotation_rad));
  const double s = std::abs(std::sin(state_.rotation_rad));
  const QRectF area = area_m.normalized();
  const double grow = 1.0 + 2.0 * margin;
  const double seen_width = (area.width() * c + area.height() * s) * grow;
  const double seen_height = (area.width() * s + area.height() * c) * grow;
  const double m_per_px = std::max({seen_width / std::max(1, width()), seen_height / std::max(1, height()), 1e-9});
  setViewState({area.center(), m_per_px, state_.rotation_rad});
}

void MapView::showActualSize() {
  if (!frame_) return;
  stopAnimation();
  fitted_ = false;
  changeState({state_.center_m, frame_->resolution() * devicePixelRatioF(), state_.rotation_rad});
}

void MapView::zoomBy(double factor) {
  zoomAt(QPointF(width() / 2.0, height() / 2.0), factor);
}

void MapView::zoomAt(const QPointF& widget_px, double factor) {
  if (!(factor > 0.0) || !std::isfinite(factor)) return;
  stopAnimation();
  fitted_ = false;
  const QPointF kept = metresFromWidget(widget_px);
  ViewState next = state_;
  next.m_per_px = clampedResolution(state_.m_per_px / factor);
  next.center_m = kept + (state_.center_m - kept) * (next.m_per_px / state_.m_per_px);
  changeState(next);
}

void MapView::setRotation(double rotation_rad) {
  stopAnimation();
  changeState({state_.center_m, state_.m_per_px, rotation_rad});
}

void MapView::rotateAt(const QPointF& widget_px, double angle_rad) {
  stopAnimation();
  fitted_ = false;
  const QPointF kept = metresFromWidget(widget_px);
  const QPointF arm = state_.center_m - kept;
  const double c = std::cos(-angle_rad);
  const double s = std::sin(-angle_rad);
  const QPointF turned(c * arm.x() - s * arm.y(), s * arm.x() + c * arm.y());
  changeState({kept + turned, state_.m_per_px, state_.rotation_rad + angle_rad});
}

void MapView::centerOn(const QPointF& point_m, bool animated) {
  if (!isUsable({point_m, state_.m_per_px, state_.rotation_rad})) return;  // or the way there would be gone in part
  stopAnimation();
  fitted_ = false;
  if (!animated || !isVisible()) {
    changeState({point_m, state_.m_per_px, state_.rotation_rad});
    return;
  }
  animation_.setStartValue(state_.center_m);
  animation_.setEndValue(point_m);
  animation_.start();
}

void MapView::stopAnimation() {
  if (animation_.state() != QAbstractAnimation::Stopped) animation_.stop();
}

bool MapView::isInView(const QPointF& point_m, double margin_px) const {
  return QRectF(rect()).adjusted(margin_px, margin_px, -margin_px, -margin_px).contains(widgetFromMetres(point_m));
}

void MapView::panByKey(const QPointF& direction, bool fine) {
  constexpr double kStep_px = 60.0;
  constexpr double kSmallStep_px = 6.0;
  const QPointF way = metresFromWidget(direction * (fine ? kSmallStep_px : kStep_px)) - metresFromWidget(QPointF(0, 0));
  stopAnimation();
  fitted_ = false;
  moved_by_keys_ = true;
  changeState({state_.center_m + way, state_.m_per_px, state_.rotation_rad});
}

void MapView::clickInMiddle() {
  if (!raster_.source() || !frame_) return;
  moved_by_keys_ = true;
  emit clicked(metresFromWidget(QRectF(rect()).center()), Qt::NoModifier, false);
}

void MapView::endGesture(Qt::KeyboardModifiers modifiers) {
  const Gesture ended = std::exchange(gesture_, Gesture::kNone);
  const std::optional<Hit> pressed = std::exchange(pressed_, std::nullopt);
  switch (ended) {
    case Gesture::kPressed:
      if (pressed) {
        emit markerClicked(pressed->id, modifiers);
      } else {
        const bool snapped = snap_m_.has_value();
        const QPointF point_m = snapped ? *snap_m_ : metresFromWidget(press_);
        snap_m_.reset();
        emit clicked(point_m, modifiers, snapped);
      }
      break;
    case Gesture::kDragMarker:
      emit dragFinished(pressed->id, drag_point_m_, drag_snapped_);
      break;
    case Gesture::kTurnPose:
      emit poseTurnFinished(pressed->id, drag_heading_);
      break;
    case Gesture::kTurnView:
      if (cursor_ && std::hypot(cursor_->x() - press_.x(), cursor_->y() - press_.y()) < kClickReach_px)
        setRotation(0.0);
      break;
    case Gesture::kNone:
    case Gesture::kPan:
    case Gesture::kSpent:
      break;
  }
}

void MapView::moveCursor(const QPointF& widget_px) {
  const bool was_at_legend = cursor_ && legend_rect_.contains(*cursor_);
  cursor_ = widget_px;
  moved_by_keys_ = false;
  if (legend_rect_.contains(widget_px) != was_at_legend) update();
}

void MapView::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  const QPoint origin = mapTo(window(), QPoint());
  const QSize change = size() - event->oldSize();
  const bool aimed_at = !locked_ && qobject_cast<const MapView*>(QApplication::widgetAt(QCursor::pos())) != nullptr;
  const bool by_message = isVisible() && (aimed_at || !fitted_) && window()->size() == window_size_ &&
                          event->oldSize().isValid() &&
                          std::max(std::abs(change.width()), std::abs(change.height())) <= kMessages_px;
  if (by_message) {
    // A message came or went beside the view: what is under the cursor stays there, or the next click misses. A map
    // that nobody is about to click in is rather seen whole.
    const QPointF middle = QRectF(rect()).center() + QPointF(origin - origin_in_window_);
    state_.center_m = metres_from_widget_.map(middle);
  }
  // The mouse has not moved, the view has: what is being dragged or panned goes on from there.
  const QPointF moved(origin_in_window_ - origin);
  press_ += moved;
  last_ += moved;
  if (cursor_) *cursor_ += moved;
  origin_in_window_ = origin;
  window_size_ = window()->size();
  updateTransform();
  if (fitted_ && !by_message) fit();  // nobody has moved the view since: keep the whole raster in it
  emit viewStateChanged();
}

void MapView::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  paint_turn_.forgetPixels();
}

QSize MapView::sizeHint() const {
  return {520, 420};
}
QSize MapView::minimumSizeHint() const {
  return {160, 120};
}

}  // namespace cad2slam
