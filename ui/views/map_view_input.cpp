// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <QContextMenuEvent>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QInputDevice>
#include <QMimeData>
#include <QMouseEvent>
#include <QNativeGestureEvent>
#include <QUrl>
#include <QWheelEvent>

#include "ui/convert.h"
#include "ui/views/corner_finder.h"
#include "ui/views/map_decorations.h"
#include "ui/views/map_view.h"

namespace cad2slam {
namespace {

constexpr double kClickReach_px = 4.0;
constexpr double kMarkerReach_px = 12.0;
constexpr double kHandleReach_px = 9.0;
constexpr double kSnapReach_px = 10.0;
constexpr double kZoomPerNotch = 1.25;
constexpr double kTurnPerNotch_rad = kPi / 36.0;
constexpr qint64 kBurst_ms = 1000;

double lengthOf(const QPointF& way) {
  return std::hypot(way.x(), way.y());
}

}  // namespace

std::optional<MapView::Hit> MapView::hitAt(const QPointF& widget_px) const {
  std::optional<Hit> best;
  double best_distance = kMarkerReach_px;
  const auto consider = [&](double distance, const Hit& hit) {
    if (distance > best_distance) return;
    best = hit;
    best_distance = distance;
  };
  for (const PoseGlyph& pose : poses_) {
    if (pose.id == kNoMarker) continue;
    const QPointF at = widgetFromMetres(pose.point_m);
    const double radius_px = pose.radius_m / state_.m_per_px;
    if (pose.turnable) {
      const QPointF handle = at + MarkerPainter::turnHandle(radius_px, -(pose.heading_rad + state_.rotation_rad));
      const double distance = lengthOf(widget_px - handle);
      if (distance <= kHandleReach_px) consider(distance, {pose.id, pose.point_m, true, true});
    }
    const double outside = lengthOf(widget_px - at) - MarkerPainter::poseRadius(radius_px);
    if (outside <= 0.0)
      consider(std::min(lengthOf(widget_px - at), kMarkerReach_px), {pose.id, pose.point_m, true, false});
  }
  // A pose is there for a while and to be dragged: over a marker it is what is meant.
  if (markers_visible_ && !best) {
    for (const Marker& marker : markers_) {
      consider(lengthOf(widget_px - widgetFromMetres(marker.point_m)), {marker.id, marker.point_m, false, false});
    }
  }
  return best;
}

const Marker* MapView::selectedMarker() const {
  const auto found =
      std::find_if(markers_.begin(), markers_.end(), [](const Marker& marker) { return marker.selected; });
  return found == markers_.end() ? nullptr : &*found;
}

void MapView::findSnap(const QPointF& widget_px, Qt::KeyboardModifiers modifiers) {
  const std::optional<QPointF> before = snap_m_;
  snap_m_.reset();
  const std::shared_ptr<RasterSource>& image = raster_.source();
  if (snapping_ && !modifiers.testFlag(Qt::AltModifier) && image && frame_ && !image->size().isEmpty()) {
    const double device_px_per_image_px = frame_->resolution() / state_.m_per_px * devicePixelRatioF();
    const int level = RasterLayer::levelForScale(device_px_per_image_px, image->levelCount());
    const double reach = kSnapReach_px * state_.m_per_px / frame_->resolution();
    const QPointF near_px = imagePixelFromMetres(metresFromWidget(widget_px));
    if (const std::optional<QPointF> corner = findCorner(*image, near_px, reach, level)) {
      const QPointF point = toQPointF(frame_->metricFromPixel(toEigen(*corner)));
      if (lengthOf(widgetFromMetres(point) - widget_px) <= kSnapReach_px + 1.0) snap_m_ = point;
    }
  }
  if (snap_m_ != before) update();
}

void MapView::showHover(Qt::KeyboardModifiers modifiers) {
  const std::optional<Hit> hit = cursor_ ? hitAt(*cursor_) : std::nullopt;
  const MarkerId id = hit ? hit->id : kNoMarker;
  const bool on_compass = cursor_ && decoration::compassRect(size()).contains(*cursor_);
  if (on_compass != compass_hovered_) update();
  compass_hovered_ = on_compass;
  if (hit || on_compass || !cursor_ || space_held_) {
    if (snap_m_) update();
    snap_m_.reset();
  } else {
    findSnap(*cursor_, modifiers);
  }
  if (id != hovered_) {
    hovered_ = id;
    update();
    emit hoveredMarkerChanged(id);
  }
  showCursorShape();
}

void MapView::showCursorShape() {
  if (gesture_ == Gesture::kPan) {
    setCursor(Qt::ClosedHandCursor);
  } else if (space_held_) {
    setCursor(Qt::OpenHandCursor);
  } else if (compass_hovered_) {
    setCursor(Qt::PointingHandCursor);
  } else if (hovered_ != kNoMarker || isDragging()) {
    setCursor(locked_ ? Qt::PointingHandCursor : Qt::SizeAllCursor);
  } else {
    setCursor(raster_.source() ? Qt::CrossCursor : Qt::ArrowCursor);
  }
}

void MapView::mousePressEvent(QMouseEvent* event) {
  stopAnimation();
  if (!raster_.source() || !frame_) {
    if (event->button() == Qt::LeftButton) emit chooseRequested();
    return;
  }
  if (gesture_ != Gesture::kNone) return;
  press_ = last_ = event->position();
  cursor_ = press_;
  pressed_.reset();
  if (event->button() == Qt::MiddleButton || (event->button() == Qt::LeftButton && space_held_)) {
    gesture_ = Gesture::kPan;
  } else if (event->button() == Qt::LeftButton) {
    if (decoration::compassRect(size()).contains(press_)) {
      gesture_ = Gesture::kTurnView;
    } else {
      gesture_ = Gesture::kPressed;
      pressed_ = hitAt(press_);
      long_press_.start();
      if (pressed_) emit markerPressed(pressed_->id, event->modifiers());
    }
  } else {
    return;
  }
  gesture_button_ = event->button();
  showCursorShape();
}

void MapView::beginDrag() {
  gesture_ = pressed_->on_handle ? Gesture::kTurnPose : Gesture::kDragMarker;
  grab_offset_ = widgetFromMetres(pressed_->point_m) - press_;
  drag_point_m_ = pressed_->point_m;
  drag_snapped_ = false;
  emit dragStarted(pressed_->id);
}

void MapView::moveDrag(Qt::KeyboardModifiers modifiers) {
  if (gesture_ == Gesture::kTurnPose) {
    const QPointF arm = metresFromWidget(*cursor_) - pressed_->point_m;
    if (arm.isNull()) return;
    drag_heading_ = std::atan2(arm.y(), arm.x());
    if (modifiers.testFlag(Qt::ShiftModifier)) {
      drag_heading_ = std::round(drag_heading_ / (kPi / 12.0)) * (kPi / 12.0);
    }
    emit poseTurned(pressed_->id, drag_heading_);
    return;
  }
  const QPointF at = *cursor_ + grab_offset_;
  if (pressed_->is_pose) {
    snap_m_.reset();
  } else {
    findSnap(at, modifiers);
  }
  drag_snapped_ = snap_m_.has_value();
  drag_point_m_ = drag_snapped_ ? *snap_m_ : metresFromWidget(at);
  emit dragMoved(pressed_->id, drag_point_m_);
}

void MapView::cancelDrag() {
  const MarkerId id = pressed_->id;
  gesture_ = Gesture::kSpent;
  pressed_.reset();
  snap_m_.reset();
  update();
  emit dragCancelled(id);
}

void MapView::mouseMoveEvent(QMouseEvent* event) {
  const QPointF at = event->position();
  const QPointF step = at - last_;
  cursor_ = at;
  if (!raster_.source() || !frame_) return;
  if (gesture_ != Gesture::kNone && !event->buttons().testFlag(gesture_button_)) {
    // A dialog that came up meanwhile got the release. A drag ends where it was; what was a mere press is no click
    // here.
    long_press_.stop();
    long_pressed_ = false;
    if (gesture_ == Gesture::kPressed || gesture_ == Gesture::kTurnView) gesture_ = Gesture::kSpent;
    endGesture(event->modifiers());
  }
  if (gesture_ == Gesture::kPressed && lengthOf(at - press_) >= kClickReach_px) {
    long_press_.stop();
    long_pressed_ = false;
    if (pressed_ && !(locked_ && !pressed_->is_pose)) {
      beginDrag();
    } else {
      gesture_ = Gesture::kPan;
      snap_m_.reset();
      showCursorShape();
    }
  }
  switch (gesture_) {
    case Gesture::kNone:
      showHover(event->modifiers());
      break;
    case Gesture::kPan: {
      const QPointF way = metresFromWidget(QPointF(0, 0)) - metresFromWidget(step);
      fitted_ = false;
      changeState({state_.center_m + way, state_.m_per_px, state_.rotation_rad});
      break;
    }
    case Gesture::kDragMarker:
    case Gesture::kTurnPose:
      moveDrag(event->modifiers());
      break;
    case Gesture::kTurnView: {
      const QPointF middle = decoration::compassRect(size()).center();
      const QPointF from = last_ - middle;
      const QPointF to = at - middle;
      if (lengthOf(at - press_) >= kClickReach_px && lengthOf(to) > 3.0 && lengthOf(from) > 3.0) {
        const double turn = -wrapAngle(std::atan2(to.y(), to.x()) - std::atan2(from.y(), from.x()));
        rotateAt(QPointF(width() / 2.0, height() / 2.0), turn);
      }
      break;
    }
    case Gesture::kPressed:
    case Gesture::kSpent:
      break;
  }
  last_ = at;
  if (crosshair_ || loupe_on_ || loupe_held_) update();
  const QPointF point_m = metresFromWidget(at);
  emit cursorMoved(point_m, imagePixelFromMetres(point_m));
}

void MapView::mouseReleaseEvent(QMouseEvent* event) {
  long_press_.stop();
  if (long_pressed_) update();
  long_pressed_ = false;
  moveCursor(event->position());
  if (event->button() == Qt::RightButton && gesture_ == Gesture::kNone) {
    if (!raster_.source() || !frame_) return;
    const std::optional<Hit> hit = hitAt(*cursor_);
    if (hit) {
      emit markerMenuRequested(hit->id, event->globalPosition().toPoint());
    } else {
      emit menuRequested(metresFromWidget(*cursor_), event->globalPosition().toPoint());
    }
    return;
  }
  if (gesture_ == Gesture::kNone || event->button() != gesture_button_) return;
  endGesture(event->modifiers());
  showHover(event->modifiers());
}

void MapView::mouseDoubleClickEvent(QMouseEvent* event) {
  const std::optional<Hit> hit = raster_.source() && frame_ ? hitAt(event->position()) : std::nullopt;
  if (event->button() == Qt::LeftButton && hit && !space_held_) {
    emit markerDoubleClicked(hit->id);
    return;
  }
  mousePressEvent(event);  // two quick clicks are two clicks
}

void MapView::wheelEvent(QWheelEvent* event) {
  if (!raster_.source() || !frame_) {
    event->ignore();
    return;
  }
  const QPoint angle = event->angleDelta();
  const QPointF at = event->position();
  const bool zoom_wanted = event->modifiers().testFlag(Qt::ControlModifier);
  const bool touchpad = event->device() != nullptr && event->device()->type() == QInputDevice::DeviceType::TouchPad &&
                        !event->pixelDelta().isNull();
  if (touchpad && !zoom_wanted && !event->modifiers().testFlag(Qt::ShiftModifier)) {
    // Two fingers push the map; pinching, or Ctrl, zooms.
    const QPointF way = metresFromWidget(QPointF(0, 0)) - metresFromWidget(QPointF(event->pixelDelta()));
    stopAnimation();
    fitted_ = false;
    changeState({state_.center_m + way, state_.m_per_px, state_.rotation_rad});
  } else {
    const double notches = (angle.y() != 0 ? angle.y() : angle.x()) / 120.0;
    if (event->modifiers().testFlag(Qt::ShiftModifier)) {
      rotateAt(at, notches * kTurnPerNotch_rad);
    } else {
      zoomAt(at, std::pow(kZoomPerNotch, notches));
    }
  }
  if (isDragging() && cursor_) {
    moveDrag(event->modifiers());
  } else if (gesture_ == Gesture::kNone) {
    cursor_ = at;
    showHover(event->modifiers());
  }
  const QPointF point_m = metresFromWidget(at);
  emit cursorMoved(point_m, imagePixelFromMetres(point_m));
  event->accept();
}

bool MapView::event(QEvent* event) {
  if (event->type() == QEvent::NativeGesture && raster_.source() && frame_) {
    const auto* gesture = static_cast<QNativeGestureEvent*>(event);
    if (gesture->gestureType() == Qt::ZoomNativeGesture) {
      zoomAt(gesture->position(), std::max(0.1, 1.0 + gesture->value()));
      return true;
    }
    if (gesture->gestureType() == Qt::RotateNativeGesture) {
      rotateAt(gesture->position(), -gesture->value() * kPi / 180.0);
      return true;
    }
  }
  return QWidget::event(event);
}

void MapView::showLoupeWhileHeld(bool held) {
  if (loupe_held_ == held) return;
  setLoupeHeld(held);
  emit loupeHeld(held);
}

bool MapView::nudge(int key, Qt::KeyboardModifiers modifiers) {
  QPointF direction;
  if (key == Qt::Key_Left) direction = {-1, 0};
  if (key == Qt::Key_Right) direction = {1, 0};
  if (key == Qt::Key_Up) direction = {0, -1};
  if (key == Qt::Key_Down) direction = {0, 1};
  if (direction.isNull() || !frame_) return false;
  if (selectedMarker() == nullptr) {
    panByKey(direction, modifiers.testFlag(Qt::ControlModifier));
    return true;
  }
  if (locked_) return true;
  double steps = 1.0;
  if (modifiers.testFlag(Qt::ShiftModifier)) steps = 10.0;
  if (modifiers.testFlag(Qt::ControlModifier)) steps = 0.1;
  const QPointF unit_m = (metresFromWidget(direction) - metresFromWidget(QPointF(0, 0))) / state_.m_per_px;
  if (!last_nudge_.isValid() || last_nudge_.elapsed() > kBurst_ms) ++burst_;
  last_nudge_.restart();
  emit nudged(unit_m * (frame_->resolution() * steps), burst_);
  return true;
}

void MapView::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
    case Qt::Key_Escape:
      if (isDragging()) {
        cancelDrag();
      } else if (gesture_ == Gesture::kNone || gesture_ == Gesture::kSpent) {
        emit cancelRequested();
      } else {
        gesture_ = Gesture::kSpent;
        pressed_.reset();
        long_press_.stop();
      }
      return;
    case Qt::Key_Return:
    case Qt::Key_Enter:
      raster_.source() && frame_ ? emit acceptRequested() : emit chooseRequested();
      return;
    case Qt::Key_Delete:
    case Qt::Key_Backspace:
      if (!isDragging()) emit deleteRequested();
      return;
    case Qt::Key_Space:
      if (!event->isAutoRepeat()) {
        space_held_ = true;
        showHover(event->modifiers());
      }
      return;
    case Qt::Key_Z:
      if (event->modifiers() != Qt::NoModifier) break;
      if (!event->isAutoRepeat()) showLoupeWhileHeld(true);
      return;
    case Qt::Key_L:
      if (event->modifiers() != Qt::NoModifier) break;
      if (!event->isAutoRepeat()) setLoupe(!loupe_on_);
      return;
    case Qt::Key_Plus:
    case Qt::Key_Equal:
      zoomBy(kZoomPerNotch);
      return;
    case Qt::Key_Minus:
      zoomBy(1.0 / kZoomPerNotch);
      return;
    case Qt::Key_Alt:
      if (gesture_ == Gesture::kNone) showHover(event->modifiers() | Qt::AltModifier);
      break;
    default:
      if (!isDragging() && nudge(event->key(), event->modifiers())) return;
  }
  QWidget::keyPressEvent(event);
}

void MapView::keyReleaseEvent(QKeyEvent* event) {
  if (!event->isAutoRepeat()) {
    if (event->key() == Qt::Key_Space) {
      space_held_ = false;
      showHover(event->modifiers());
      return;
    }
    if (event->key() == Qt::Key_Z && loupe_held_) {
      showLoupeWhileHeld(false);
      return;
    }
    if (event->key() == Qt::Key_Alt && gesture_ == Gesture::kNone) {
      showHover(event->modifiers() & ~Qt::KeyboardModifiers(Qt::AltModifier));
    }
  }
  QWidget::keyReleaseEvent(event);
}

void MapView::leaveEvent(QEvent* event) {
  QWidget::leaveEvent(event);
  cursor_.reset();
  snap_m_.reset();
  if (gesture_ == Gesture::kNone) showHover(Qt::NoModifier);
  update();
  emit cursorLeft();
}

void MapView::focusInEvent(QFocusEvent* event) {
  QWidget::focusInEvent(event);
  update();
}

void MapView::focusOutEvent(QFocusEvent* event) {
  QWidget::focusOutEvent(event);
  space_held_ = false;
  showLoupeWhileHeld(false);
  showCursorShape();
  update();
}

void MapView::contextMenuEvent(QContextMenuEvent* event) {
  event->accept();
  if (event->reason() == QContextMenuEvent::Mouse) return;  // mouseReleaseEvent() has told
  if (const Marker* marker = selectedMarker()) {
    emit markerMenuRequested(marker->id, mapToGlobal(widgetFromMetres(marker->point_m).toPoint()));
  }
}

void MapView::dragEnterEvent(QDragEnterEvent* event) {
  if (!event->mimeData()->hasUrls()) return;
  event->acceptProposedAction();
  drop_hover_ = true;
  update();
}

void MapView::dragLeaveEvent(QDragLeaveEvent*) {
  drop_hover_ = false;
  update();
}

void MapView::dropEvent(QDropEvent* event) {
  drop_hover_ = false;
  update();
  QStringList paths;
  for (const QUrl& url : event->mimeData()->urls()) {
    if (url.isLocalFile()) paths << url.toLocalFile();
  }
  if (paths.isEmpty()) return;
  event->acceptProposedAction();
  emit filesDropped(paths);
}

}  // namespace cad2slam
