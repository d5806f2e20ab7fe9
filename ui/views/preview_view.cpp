// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/views/preview_view.h"

#include <algorithm>
#include <cmath>

#include <QKeyEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QPainterPath>

#include "cad2slam/geometry/angle.h"
#include "ui/views/map_decorations.h"

namespace cad2slam {
namespace {

constexpr int kBlink_ms = 300;
constexpr double kBarReach_px = 8.0;
constexpr double kLensRadius_px = 95.0;
constexpr double kFaint = 0.35;
constexpr double kHeatOpacity = 0.65;
// More rows are drawn by Qt's threads, for which the window would wait while a solve keeps all processors busy.
constexpr double kBandRows_px = 64.0;
const QColor kBanner(0xb2, 0x5d, 0x00);

bool isHeat(PreviewMode mode) {
  return mode == PreviewMode::kStretch || mode == PreviewMode::kRotation || mode == PreviewMode::kCoverage;
}

}  // namespace

PreviewView::PreviewView(QWidget* parent) : MapView(parent) {
  setAccessibleName(tr("Preview"));
  setAcceptDrops(false);  // files belong into one of the maps
  setSnapping(false);
  setMapFirst(true);
  setMagnificationNote(false);  // the legend tells it
  setLocked(true);
  blink_timer_.setInterval(kBlink_ms);
  connect(&blink_timer_, &QTimer::timeout, this, [this] {
    blink_shows_other_ = !blink_shows_other_;
    update();
  });
  connect(this, &MapView::viewStateChanged, this, [this] {
    if (!isCovered()) emit pictureWanted();
  });
}

void PreviewView::setMode(PreviewMode mode) {
  if (mode_ == mode) return;
  const bool other_kind =
      previewKind(mode) != previewKind(mode_) || (mode == PreviewMode::kAllMaps) != (mode_ == PreviewMode::kAllMaps);
  mode_ = mode;
  setMarkersAsDots(mode == PreviewMode::kResiduals);
  if (other_kind) picture_ = {};
  update();
  emit pictureWanted();
}

void PreviewView::setOpacity(double opacity) {
  const double clamped = std::clamp(opacity, 0.0, 1.0);
  if (clamped == opacity_) return;
  opacity_ = clamped;
  update();
  emit opacityChanged(opacity_);
}

void PreviewView::setAutoBlink(bool on) {
  if (on) {
    blink_timer_.start();
  } else {
    blink_timer_.stop();
    blink_shows_other_ = false;
  }
  update();
}

void PreviewView::setBlinkHeld(bool held) {
  if (blink_held_ == held) return;
  blink_held_ = held;
  update();
}

void PreviewView::setSwipe(double part) {
  const double clamped = std::clamp(part, 0.0, 1.0);
  if (clamped == swipe_) return;
  swipe_ = clamped;
  update();
  emit swipeChanged(swipe_);
}

void PreviewView::setPicture(const PreviewPicture& picture) {
  if (picture.kind != previewKind(mode_)) return;  // of the mode before
  picture_ = picture;
  update();
}
void PreviewView::clearPicture() {
  picture_ = {};
  update();
}
void PreviewView::setInks(std::vector<InkEntry> inks) {
  inks_ = std::move(inks);
  update();
}
void PreviewView::setReason(const QString& reason) {
  if (reason_ == reason) return;
  reason_ = reason;
  update();
}
void PreviewView::setNotCurrent(const QString& reason) {
  if (not_current_ == reason) return;
  not_current_ = reason;
  update();
}

void PreviewView::setRough(bool rough) {
  if (rough_ == rough) return;
  rough_ = rough;
  update();
}

bool PreviewView::isCovered() const {
  const ViewState state = viewState();
  if (picture_.image.isNull() || picture_.state.m_per_px != state.m_per_px ||
      picture_.state.rotation_rad != state.rotation_rad ||
      picture_.image.width() < std::lround(picture_.size.width() * devicePixelRatioF())) {
    return false;
  }
  const QPointF shift = picture_.state.widgetFromMetres(picture_.size).map(state.center_m) -
                        QPointF(picture_.size.width() / 2.0, picture_.size.height() / 2.0);
  return std::abs(shift.x()) <= (picture_.size.width() - width()) / 2.0 &&
         std::abs(shift.y()) <= (picture_.size.height() - height()) / 2.0;
}

void PreviewView::paintPicture(QPainter& painter, double opacity) {
  if (picture_.image.isNull() || !reason_.isEmpty()) return;
  const QTransform now = viewState().widgetFromMetres(size());
  const QTransform then = picture_.state.widgetFromMetres(picture_.size);
  const double ratio = static_cast<double>(picture_.image.width()) / std::max(1, picture_.size.width());
  const QTransform moved = then.inverted() * now;
  // A picture of lower resolution stands in until the sharp one is there: smooth it.
  const bool exact = moved.type() <= QTransform::TxTranslate && ratio >= devicePixelRatioF() * 0.99;
  const double band = exact ? height() + 1.0 : kBandRows_px / devicePixelRatioF();
  // Edges a little off whole device rows: whatever the view's place on a screen of 150 %, no edge is a tie in rounding.
  const double off = -0.29 / devicePixelRatioF();
  for (int i = 0; off + i * band < height(); ++i) {
    painter.save();
    painter.setClipRect(QRectF(QPointF(0.0, off + i * band), QPointF(width(), off + (i + 1) * band)),
                        Qt::IntersectClip);
    painter.setOpacity(opacity);
    painter.setRenderHint(QPainter::SmoothPixmapTransform, !exact);
    painter.setTransform(moved, true);
    painter.scale(1.0 / ratio, 1.0 / ratio);
    painter.drawImage(QPointF(0, 0), picture_.image);
    painter.restore();
  }
}

void PreviewView::paintBase(QPainter& painter) {
  MapView::paintBase(painter);
  if (mode_ == PreviewMode::kBlink) {
    if (blink_held_ || blink_shows_other_) paintPicture(painter, 1.0);
    return;
  }
  if (blink_held_) return;
  switch (mode_) {
    case PreviewMode::kOverlay:
      paintPicture(painter, rough_ ? std::min(opacity_, kFaint) : opacity_);
      break;
    case PreviewMode::kTwoInk:
    case PreviewMode::kAllMaps:
      paintPicture(painter, 1.0);
      break;
    case PreviewMode::kSwipe: {
      const double x = swipe_ * width();
      painter.save();
      painter.setClipRect(QRectF(x, 0.0, width() - x, height()));
      paintPicture(painter, 1.0);
      painter.restore();
      break;
    }
    case PreviewMode::kLens:
      if (pointer_) {
        QPainterPath lens;
        lens.addEllipse(*pointer_, kLensRadius_px, kLensRadius_px);
        painter.save();
        painter.setClipPath(lens);
        painter.fillPath(lens, Qt::white);
        paintPicture(painter, 1.0);
        painter.restore();
      }
      break;
    case PreviewMode::kMesh:
    case PreviewMode::kResiduals:
      paintPicture(painter, std::min(opacity_, kFaint));
      break;
    case PreviewMode::kStretch:
    case PreviewMode::kRotation:
    case PreviewMode::kCoverage:
      paintPicture(painter, kHeatOpacity);
      break;
    case PreviewMode::kBlink:
      break;
  }
}

void PreviewView::paintOnTop(QPainter& painter) {
  if (mode_ == PreviewMode::kSwipe && reason_.isEmpty()) {
    const double x = swipe_ * width();
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(Qt::white, 5.0));
    painter.drawLine(QPointF(x, 0), QPointF(x, height()));
    painter.setPen(QPen(decoration::attentionColor(), 2.5));
    painter.drawLine(QPointF(x, 0), QPointF(x, height()));
    const QPointF grip(x, height() / 2.0);
    painter.setBrush(Qt::white);
    painter.drawEllipse(grip, 13.0, 13.0);
    for (const double side : {-1.0, 1.0}) {
      const QPointF tip = grip + QPointF(side * 8.0, 0.0);
      painter.drawLine(tip, tip + QPointF(-side * 4.0, -4.0));
      painter.drawLine(tip, tip + QPointF(-side * 4.0, 4.0));
    }
    painter.restore();
  }
  if (mode_ == PreviewMode::kLens && pointer_) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(Qt::white, 5.0));
    painter.drawEllipse(*pointer_, kLensRadius_px, kLensRadius_px);
    painter.setPen(QPen(decoration::attentionColor(), 2.5));
    painter.drawEllipse(*pointer_, kLensRadius_px, kLensRadius_px);
    painter.restore();
  }
  if (!reason_.isEmpty()) {
    decoration::paintChip(painter, QPointF(width() / 2.0, 10.0), reason_, QColor(50, 54, 60, 225), width() - 110.0);
    return;
  }
  if (!not_current_.isEmpty()) {
    decoration::paintChip(painter, QPointF(width() / 2.0, 10.0), not_current_, kBanner, width() - 110.0);
  }
}

QString PreviewView::legendTitle() const {
  switch (mode_) {
    case PreviewMode::kOverlay:
      return tr("Overlay, %1 %").arg(std::lround(opacity_ * 100.0));
    case PreviewMode::kTwoInk:
      return tr("Two inks");
    case PreviewMode::kSwipe:
      return tr("Swipe");
    case PreviewMode::kBlink:
      return tr("Blink");
    case PreviewMode::kLens:
      return tr("Lens");
    case PreviewMode::kMesh:
      break;
    case PreviewMode::kResiduals:
      return tr("Residuals, %1 times as long").arg(QLocale().toString(residualMagnification(), 'g', 3));
    case PreviewMode::kStretch:
      return tr("Local scale against the mean");
    case PreviewMode::kRotation:
      return tr("Local turn against the mean");
    case PreviewMode::kCoverage:
      return tr("Distance to the nearest anchor");
    case PreviewMode::kAllMaps:
      return tr("All SLAM maps");
  }
  return {};
}

QString PreviewView::legendHint() const {
  switch (mode_) {
    case PreviewMode::kOverlay:
      return tr("[ and ] change it, hold B to hide it");
    case PreviewMode::kSwipe:
      return tr("Drag the bar");
    case PreviewMode::kBlink:
      return tr("Hold B for the other map");
    case PreviewMode::kResiduals:
      return tr("From the projected to the clicked place");
    case PreviewMode::kCoverage:
      return tr("Anchors help most where it is red");
    default:
      return {};
  }
}

std::vector<PreviewLegend::Row> PreviewView::legendRows() const {
  std::vector<PreviewLegend::Row> rows;
  const auto nameOf = [this](std::size_t i) { return i < inks_.size() ? inks_[i].name : QString(); };
  switch (mode_) {
    case PreviewMode::kTwoInk:
    case PreviewMode::kAllMaps:
      for (const InkEntry& ink : inks_) rows.push_back({ink.color, ink.name});
      if (mode_ == PreviewMode::kTwoInk) rows.push_back({QColor(), tr("Dark: both agree")});
      break;
    case PreviewMode::kSwipe:
      rows.push_back({QColor(), tr("left: %1").arg(nameOf(0))});
      rows.push_back({QColor(), tr("right: %1").arg(nameOf(1))});
      break;
    case PreviewMode::kLens:
      rows.push_back({QColor(), tr("around: %1").arg(nameOf(0))});
      rows.push_back({QColor(), tr("in the lens: %1").arg(nameOf(1))});
      break;
    case PreviewMode::kBlink:
      rows.push_back({QColor(), blink_held_ || blink_shows_other_ ? nameOf(1) : nameOf(0)});
      break;
    case PreviewMode::kOverlay:
      rows.push_back({QColor(), tr("%1 over %2").arg(nameOf(1), nameOf(0))});
      break;
    case PreviewMode::kMesh:
      break;
    case PreviewMode::kResiduals:
      rows.push_back({colorOf(MarkerClass::kOk), tr("good")});
      rows.push_back({colorOf(MarkerClass::kLook), tr("worth a look")});
      rows.push_back({colorOf(MarkerClass::kBad), tr("probably wrong")});
      break;
    case PreviewMode::kStretch:
    case PreviewMode::kRotation:
      rows.push_back({QColor(0, 0, 0), tr("black: the mesh folds")});
      break;
    case PreviewMode::kCoverage:
      break;
  }
  return rows;
}

std::optional<PreviewLegend::Ramp> PreviewView::legendRamp() const {
  if (!isHeat(mode_)) return std::nullopt;
  const bool one_sided = mode_ == PreviewMode::kCoverage;
  const bool turn = mode_ == PreviewMode::kRotation;
  const double in_unit = one_sided ? 1.0 : turn ? 180.0 / kPi : 100.0;
  const double full = picture_.full_color * in_unit;
  const QString unit = one_sided ? tr(" m", "metres") : turn ? tr("\u00b0", "degrees") : tr(" %", "per cent");
  const QString number = QLocale().toString(full, 'g', 2) + unit;
  if (one_sided) return PreviewLegend::Ramp{true, QStringLiteral("0"), {}, number};
  return PreviewLegend::bothWays(number);
}

std::optional<PreviewLegend> PreviewView::legend() const {
  if (!reason_.isEmpty()) return std::nullopt;
  if (mode_ == PreviewMode::kMesh) return PreviewLegend::ofMesh(meshFullColor());
  return PreviewLegend{legendTitle(), legendRamp(), legendRows(), legendHint()};
}

bool PreviewView::isNearBar(const QPointF& at) const {
  return mode_ == PreviewMode::kSwipe && reason_.isEmpty() && std::abs(at.x() - swipe_ * width()) <= kBarReach_px;
}

void PreviewView::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton && isNearBar(event->position())) {
    dragging_bar_ = true;
    return;
  }
  MapView::mousePressEvent(event);
}

void PreviewView::mouseMoveEvent(QMouseEvent* event) {
  dragging_bar_ = dragging_bar_ && event->buttons().testFlag(Qt::LeftButton);  // a dialog may have got the release
  if (dragging_bar_) {
    setSwipe(event->position().x() / std::max(1, width()));
    return;
  }
  pointer_ = event->position();
  if (mode_ == PreviewMode::kLens) update();
  MapView::mouseMoveEvent(event);
  if (event->buttons() == Qt::NoButton && isNearBar(event->position())) setCursor(Qt::SplitHCursor);
}

void PreviewView::mouseReleaseEvent(QMouseEvent* event) {
  if (dragging_bar_) {
    dragging_bar_ = false;
    return;
  }
  MapView::mouseReleaseEvent(event);
}

void PreviewView::leaveEvent(QEvent* event) {
  pointer_.reset();
  update();
  MapView::leaveEvent(event);
}

void PreviewView::keyPressEvent(QKeyEvent* event) {
  if (event->modifiers() == Qt::NoModifier) {
    if (event->key() == Qt::Key_B) {
      if (!event->isAutoRepeat()) setBlinkHeld(true);
      return;
    }
    if (mode_ == PreviewMode::kSwipe && (event->key() == Qt::Key_Left || event->key() == Qt::Key_Right)) {
      setSwipe(swipe_ + (event->key() == Qt::Key_Right ? 0.02 : -0.02));
      return;
    }
  }
  MapView::keyPressEvent(event);
}

void PreviewView::keyReleaseEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_B && !event->isAutoRepeat()) {
    setBlinkHeld(false);
    return;
  }
  MapView::keyReleaseEvent(event);
}

}  // namespace cad2slam
