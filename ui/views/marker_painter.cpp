// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/views/marker_painter.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <QFontMetricsF>
#include <QPainterPath>

#include "ui/views/sprite_cache.h"

namespace cad2slam {
namespace {

constexpr double kSpriteHalf_px = 26.0;
constexpr double kHandleReach_px = 22.0;
constexpr double kTextEdge_px = 3.0;
const QColor kDarkEdge(0, 0, 0, 190);
const QColor kLightEdge(255, 255, 255, 235);

QPainterPath shapeOf(MarkerClass judged, double size) {
  QPainterPath path;
  switch (judged) {
    case MarkerClass::kLook: {
      const double reach = size * 1.35;
      path.moveTo(0, -reach);
      path.lineTo(reach, 0);
      path.lineTo(0, reach);
      path.lineTo(-reach, 0);
      path.closeSubpath();
      break;
    }
    case MarkerClass::kBad:
      path.addRect(QRectF(-size * 0.95, -size * 0.95, size * 1.9, size * 1.9));
      break;
    default:
      path.addEllipse(QPointF(0, 0), size, size);
  }
  return path;
}

/// A line with a light and a dark edge around it.
void strokeEdged(QPainter& painter, const QPainterPath& path, QPen pen) {
  const double width = pen.widthF();
  QPen edge(kDarkEdge, width + 3.6, Qt::SolidLine, pen.capStyle(), pen.joinStyle());
  painter.strokePath(path, edge);
  edge.setColor(kLightEdge);
  edge.setWidthF(width + 2.2);
  painter.strokePath(path, edge);
  painter.strokePath(path, pen);
}

QPen solidPen(const QColor& color, double width) {
  return QPen(color, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin);
}

double radiusOf(MarkerSize size) {
  switch (size) {
    case MarkerSize::kDot:
      return 2.5;
    case MarkerSize::kSmall:
      return 4.0;
    case MarkerSize::kNormal:
      return 7.5;
    case MarkerSize::kEnlarged:
      break;
  }
  return 10.0;
}

void paintMarkerShape(QPainter& painter, const Marker& marker, MarkerSize wanted) {
  const double size = (marker.judged == MarkerClass::kPending ? 2.0 : 0.0) + radiusOf(wanted);
  const QColor color = colorOf(marker.judged);
  const QPainterPath shape = shapeOf(marker.judged, size);
  const bool hollow = marker.judged == MarkerClass::kPending || marker.judged == MarkerClass::kDisabled;
  if (marker.selected) {
    strokeEdged(painter, shapeOf(marker.judged, size + 5.0), solidPen(color, 3.2));
  }
  QPen pen = solidPen(color, hollow ? 1.8 : 2.8);
  if (marker.judged == MarkerClass::kPending) {
    pen.setWidthF(2.4);
    pen.setCapStyle(Qt::FlatCap);
    pen.setDashPattern({2.2, 1.6});
  }
  const bool small = wanted == MarkerSize::kDot || wanted == MarkerSize::kSmall;
  if (small) pen.setWidthF(0.7 * pen.widthF());
  strokeEdged(painter, shape, pen);
  if (small) return;  // no room for details
  QPainterPath dot;
  dot.addEllipse(QPointF(0, 0), 1.3, 1.3);
  painter.strokePath(dot, QPen(kLightEdge, 2.4));
  painter.fillPath(dot, hollow ? QColor(40, 40, 40) : color.darker(130));
  if (marker.snapped) {
    QPainterPath tick;
    const double from = size + 2.0;
    tick.moveTo(from + 5.0, from - 1.0);
    tick.lineTo(from + 5.0, from + 5.0);
    tick.lineTo(from - 1.0, from + 5.0);
    QPen tick_pen = solidPen(color, 2.0);
    tick_pen.setCapStyle(Qt::SquareCap);
    strokeEdged(painter, tick, tick_pen);
  }
}

QSizeF spriteSize(double width, const QFontMetricsF& metrics) {
  return {width + 2.0 * kTextEdge_px, metrics.height() + 2.0 * kTextEdge_px};
}

}  // namespace

QColor colorOf(MarkerClass judged) {
  switch (judged) {
    case MarkerClass::kOk:
      return QColor(0x00, 0x8b, 0x7e);
    case MarkerClass::kLook:
      return QColor(0xf2, 0x9a, 0x00);
    case MarkerClass::kBad:
      return QColor(0xd8, 0x1b, 0x8c);
    case MarkerClass::kDisabled:
      return QColor(0x70, 0x70, 0x70);
    case MarkerClass::kPlain:
    case MarkerClass::kPending:
      break;
  }
  return QColor(0x1e, 0x66, 0xd0);
}

QPixmap MarkerPainter::markerSprite(const Marker& marker, MarkerSize size, double ratio) {
  const QString key = QStringLiteral("marker%1%2%3%4")
                          .arg(static_cast<int>(marker.judged))
                          .arg(marker.selected)
                          .arg(marker.snapped)
                          .arg(static_cast<int>(size));
  return sprite::findOrMake(key, QSizeF(2.0 * kSpriteHalf_px, 2.0 * kSpriteHalf_px), ratio, [&](QPainter& painter) {
    painter.translate(kSpriteHalf_px, kSpriteHalf_px);
    painter.setCompositionMode(QPainter::CompositionMode_Source);  // without threads, see sprite_cache.h
    paintMarkerShape(painter, marker, size);
  });
}

QPixmap MarkerPainter::letterSprite(const QString& letter, TextPart part, const QColor& color, double ratio) const {
  const QString look = part == TextPart::kInk ? color.name() : QString::number(static_cast<int>(part));
  const QString key = QStringLiteral("letter%1_").arg(look) + bold_key_ + letter;
  const QFontMetricsF metrics(bold_);
  return sprite::findOrMake(key, spriteSize(metrics.horizontalAdvance(letter), metrics), ratio, [&](QPainter& painter) {
    painter.setCompositionMode(QPainter::CompositionMode_Source);  // without threads, see sprite_cache.h
    QPainterPath path;
    path.addText(QPointF(kTextEdge_px, kTextEdge_px + metrics.ascent()), bold_, letter);
    if (part == TextPart::kInk) {
      painter.fillPath(path, color);
    } else {
      const bool dark = part == TextPart::kDarkEdge;
      painter.strokePath(path, solidPen(dark ? kDarkEdge : QColor(Qt::white), dark ? 4.2 : 3.2));
    }
  });
}

QPixmap MarkerPainter::textSprite(const QString& text, const QColor& color, double ratio) const {
  const QString key = QStringLiteral("text%1_").arg(color.name()) + bold_key_ + text;
  if (const auto known = sprite::find(key, ratio)) return *known;
  // Outlines are slow to draw: hundreds of numbers are put together from the ten digits. Scripts that join their
  // letters are drawn as one.
  const bool joined = std::any_of(text.begin(), text.end(), [](QChar letter) { return letter.unicode() >= 0x250; });
  const qsizetype step = joined ? text.size() : 1;
  const QFontMetricsF metrics(bold_);
  std::vector<std::pair<double, QString>> pieces;  // and where they begin
  double width = 0.0;
  for (qsizetype i = 0; i < text.size(); i += step) {
    pieces.emplace_back(width, text.mid(i, step));
    width += metrics.horizontalAdvance(pieces.back().second);
  }
  return sprite::make(key, spriteSize(width, metrics), ratio, [&](QPainter& painter) {
    for (const TextPart part : {TextPart::kDarkEdge, TextPart::kLightEdge, TextPart::kInk})
      for (const auto& [x, piece] : pieces)
        painter.drawPixmap(QPointF(x, 0.0), letterSprite(piece, part, color, ratio));
  });
}

void MarkerPainter::useFont(const QFont& font) {
  if (font == font_ && !bold_key_.isEmpty()) return;
  font_ = bold_ = font;
  bold_.setBold(true);
  bold_key_ = bold_.key();
}

QPixmap MarkerPainter::words(const QPainter& painter, const QString& text, const QColor& color) {
  useFont(painter.font());
  return textSprite(text, color.darker(145), painter.device()->devicePixelRatioF());
}

void MarkerPainter::prepare(const QPainter& painter) {
  Marker marker;
  for (const MarkerClass judged : {MarkerClass::kPlain, MarkerClass::kOk, MarkerClass::kLook}) {
    marker.judged = judged;
    for (const MarkerSize size : {MarkerSize::kSmall, MarkerSize::kNormal})
      static_cast<void>(markerSprite(marker, size, painter.device()->devicePixelRatioF()));
    static_cast<void>(words(painter, QStringLiteral("0123456789"), colorOf(judged)));
  }
}

void MarkerPainter::paintText(QPainter& painter, const QPointF& at, const QString& text, const QColor& color) {
  if (text.isEmpty()) return;
  const QPixmap sprite = words(painter, text, color);
  painter.drawPixmap(at - QPointF(kTextEdge_px, sprite.deviceIndependentSize().height() / 2.0), sprite);
}

void MarkerPainter::paintMarker(QPainter& painter, const Marker& marker, const QPointF& at, MarkerSize size) {
  painter.drawPixmap(at - QPointF(kSpriteHalf_px, kSpriteHalf_px),
                     markerSprite(marker, size, painter.device()->devicePixelRatioF()));
}

QRectF MarkerPainter::coreOf(const QPointF& at, MarkerSize size) {
  const double half = 0.95 * radiusOf(size);
  return QRectF(at - QPointF(half, half), QSizeF(2.0 * half, 2.0 * half));
}

double MarkerPainter::labelReach(const Marker& marker, MarkerSize size) {
  return radiusOf(size) + 3.5 + (marker.selected ? 5.0 : 0.0);
}

QSizeF MarkerPainter::textSize(const QPainter& painter, const Marker& marker) {
  useFont(painter.font());
  const QFontMetricsF metrics(bold_);  // no sprite: where there is no room for the text, none is needed
  return {metrics.horizontalAdvance(marker.text), metrics.height()};
}

void MarkerPainter::paintLabel(QPainter& painter, const Marker& marker, const QRectF& area) {
  paintText(painter, QPointF(area.left(), area.center().y()), marker.text, colorOf(marker.judged));
}

void MarkerPainter::paintLabel(QPainter& painter, const Marker& marker, const QPointF& at) {
  const double reach = labelReach(marker, MarkerSize::kNormal);
  paintText(painter, at + QPointF(reach, 2.0 - reach), marker.text, colorOf(marker.judged));
}

void MarkerPainter::paintGhost(QPainter& painter, const QPointF& at, double radius_px, const QString& text,
                               double view_width_px) {
  const QColor color = colorOf(MarkerClass::kPending);
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  if (radius_px > 4.0) {
    QPainterPath ring;
    ring.addEllipse(at, radius_px, radius_px);
    QColor fill = color;
    fill.setAlpha(28);
    painter.fillPath(ring, fill);
    QPen pen = solidPen(color, 1.4);
    pen.setDashPattern({5.0, 4.0});
    strokeEdged(painter, ring, pen);
  }
  painter.setOpacity(0.75);
  QPainterPath cross;
  for (const QPointF& direction : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)}) {
    cross.moveTo(at + direction * 4.0);
    cross.lineTo(at + direction * 11.0);
  }
  cross.addEllipse(at, 7.0, 7.0);
  strokeEdged(painter, cross, solidPen(color, 1.8));
  painter.restore();
  constexpr double kBeside_px = 12.0;
  useFont(painter.font());
  const double width = QFontMetricsF(bold_).horizontalAdvance(text);
  const bool fits = at.x() + kBeside_px + width < view_width_px || at.x() < kBeside_px + width;
  paintText(painter, at + QPointF(fits ? kBeside_px : -kBeside_px - width, -11.0), text, color);
}

void MarkerPainter::paintResidual(QPainter& painter, const QPointF& from, const QPointF& to, MarkerClass judged) {
  const QPointF way = to - from;
  const double length = std::hypot(way.x(), way.y());
  if (!(length > 1.0)) return;
  const QPointF along = way / length;
  const QPointF across(-along.y(), along.x());
  const double head = std::clamp(length * 0.5, 5.0, 9.0);  // seen however short the way is
  QPainterPath path;
  path.moveTo(from);
  path.lineTo(to);
  path.moveTo(to - along * head + across * head * 0.6);
  path.lineTo(to);
  path.lineTo(to - along * head - across * head * 0.6);
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  strokeEdged(painter, path, solidPen(colorOf(judged), 1.8));
  painter.restore();
}

double MarkerPainter::poseRadius(double radius_px) {
  return std::max(7.0, radius_px);
}

QPointF MarkerPainter::turnHandle(double radius_px, double heading_on_screen_rad) {
  const double reach = poseRadius(radius_px) + kHandleReach_px;
  return {reach * std::cos(heading_on_screen_rad), reach * std::sin(heading_on_screen_rad)};
}

void MarkerPainter::paintPose(QPainter& painter, const PoseGlyph& pose, const QPointF& at, double heading_on_screen_rad,
                              double radius_px, bool enlarged) {
  const double radius = poseRadius(radius_px);
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  QPainterPath body;
  body.addEllipse(at, radius, radius);
  QColor fill = pose.color;
  fill.setAlpha(pose.hollow ? 30 : 90);
  painter.fillPath(body, fill);
  QPen pen = solidPen(pose.color, enlarged ? 3.4 : 2.2);
  if (pose.hollow) pen.setDashPattern({2.0, 2.0});
  strokeEdged(painter, body, pen);

  const QPointF along(std::cos(heading_on_screen_rad), std::sin(heading_on_screen_rad));
  const QPointF across(-along.y(), along.x());
  const double nose = pose.turnable ? radius + kHandleReach_px - 5.0 : radius + 7.0;
  QPainterPath arrow;
  arrow.moveTo(at);
  arrow.lineTo(at + along * nose);
  if (!pose.turnable) {
    arrow.moveTo(at + along * (nose - 6.0) + across * 4.0);
    arrow.lineTo(at + along * nose);
    arrow.lineTo(at + along * (nose - 6.0) - across * 4.0);
  }
  strokeEdged(painter, arrow, solidPen(pose.color, 2.2));
  if (pose.turnable) {
    QPainterPath handle;
    handle.addEllipse(at + along * (radius + kHandleReach_px), 5.0, 5.0);
    strokeEdged(painter, handle, solidPen(pose.color, 2.2));
    painter.fillPath(handle, Qt::white);
  }
  painter.restore();
  // On the side that the heading leaves free.
  const double below = std::sin(heading_on_screen_rad) > 0.0 ? -1.0 : 1.0;
  paintText(painter, at + QPointF(-radius, below * (radius + 13.0)), pose.text, pose.color);
}

void MarkerPainter::paintPoseTick(QPainter& painter, const PoseGlyph& pose, const QPointF& at,
                                  double heading_on_screen_rad) {
  constexpr double kTick_px = 7.0;
  const QPointF along(std::cos(heading_on_screen_rad), std::sin(heading_on_screen_rad));
  painter.save();
  painter.setPen(QPen(pose.color, pose.hollow ? 1.0 : 2.0));
  painter.drawLine(at, at + kTick_px * along);
  painter.fillRect(QRectF(at - QPointF(1.5, 1.5), QSizeF(3.0, 3.0)), pose.color);
  painter.restore();
}

void MarkerPainter::paintPath(QPainter& painter, const PathGlyph& path, const QTransform& widget_from_metres) {
  if (path.points_m.size() < 2) return;
  QPainterPath line;
  line.moveTo(widget_from_metres.map(path.points_m.front()));
  for (std::size_t i = 1; i < path.points_m.size(); ++i) line.lineTo(widget_from_metres.map(path.points_m[i]));
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  QPen pen = solidPen(path.color, path.width_px);
  if (path.dashed) pen.setDashPattern({3.0, 2.5});
  strokeEdged(painter, line, pen);
  painter.restore();
}

void MarkerPainter::paintPathText(QPainter& painter, const PathGlyph& path, const QTransform& widget_from_metres) {
  if (path.points_m.size() < 2) return;
  paintText(painter, widget_from_metres.map(path.points_m.back()) + QPointF(8.0, -10.0), path.text, path.color);
}

void MarkerPainter::paintMirroredCursor(QPainter& painter, const QPointF& at, bool certain) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  QPainterPath cross;
  for (const QPointF& direction : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)}) {
    cross.moveTo(at + direction * 3.0);
    cross.lineTo(at + direction * 12.0);
  }
  QPen pen = solidPen(QColor(0xe6, 0x4a, 0x19), 1.8);
  if (!certain) pen.setDashPattern({1.2, 1.8});
  strokeEdged(painter, cross, pen);
  painter.restore();
}

void MarkerPainter::paintSnap(QPainter& painter, const QPointF& at) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  QPainterPath square;
  square.addRect(QRectF(at - QPointF(6, 6), QSizeF(12, 12)));
  QPen pen = solidPen(QColor(0x7b, 0x1f, 0xa2), 2.0);
  pen.setJoinStyle(Qt::MiterJoin);
  strokeEdged(painter, square, pen);
  painter.restore();
}

}  // namespace cad2slam
