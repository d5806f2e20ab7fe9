// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/views/map_decorations.h"

#include <algorithm>
#include <cmath>

#include <QFontMetricsF>
#include <QLocale>
#include <QPainterPath>
#include <QPalette>

#include "cad2slam/geometry/angle.h"
#include "ui/views/sprite_cache.h"

namespace cad2slam::decoration {
namespace {

const QColor kPanel(255, 255, 255, 225);
const QColor kRim(160, 162, 165);
const QColor kInk(25, 28, 32);

double deviceRatio(const QPainter& painter) {
  return painter.device()->devicePixelRatioF();
}

void paintPanel(QPainter& painter, const QRectF& box, const QColor& fill) {
  QPainterPath path;
  path.addRoundedRect(box, 5.0, 5.0);
  painter.fillPath(path, fill);
  painter.strokePath(path, QPen(QColor(0, 0, 0, 70), 1.0));
}

}  // namespace

QColor attentionColor() {
  return QColor(0x1e, 0x66, 0xd0);
}

double roundedDown(double value) {
  if (!(value > 0.0) || !std::isfinite(value)) return 0.0;
  const double decade = std::pow(10.0, std::floor(std::log10(value)));
  return decade * (5.0 * decade <= value ? 5.0 : 2.0 * decade <= value ? 2.0 : 1.0);
}

ScaleBar scaleBarFor(double m_per_px, double most_px) {
  ScaleBar bar;
  bar.length_m = roundedDown(m_per_px * most_px);
  if (!(bar.length_m > 0.0)) return bar;
  bar.length_px = bar.length_m / m_per_px;
  const QLocale locale;
  if (bar.length_m >= 1000.0) {
    bar.text = QStringLiteral("%1 km").arg(locale.toString(bar.length_m / 1000.0, 'g', 6));
  } else if (bar.length_m >= 1.0) {
    bar.text = QStringLiteral("%1 m").arg(locale.toString(bar.length_m, 'g', 6));
  } else if (bar.length_m >= 0.01) {
    bar.text = QStringLiteral("%1 cm").arg(locale.toString(bar.length_m * 100.0, 'g', 6));
  } else {
    bar.text = QStringLiteral("%1 mm").arg(locale.toString(bar.length_m * 1000.0, 'g', 6));
  }
  return bar;
}

void paintScaleBar(QPainter& painter, const QSizeF& view, double m_per_px) {
  const ScaleBar bar = scaleBarFor(m_per_px, std::min({150.0, view.width() * 0.35, view.height() * 0.4}));
  if (bar.text.isEmpty()) return;
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  const QFontMetricsF metrics(painter.font());
  const double width = std::max(bar.length_px, metrics.horizontalAdvance(bar.text)) + 16.0;
  const QRectF box(8.0, view.height() - metrics.height() - 22.0, width, metrics.height() + 14.0);
  paintPanel(painter, box, kPanel);
  painter.setPen(kInk);
  painter.drawText(QRectF(box.x(), box.y() + 2.0, box.width(), metrics.height()), Qt::AlignCenter, bar.text);
  const double y = box.bottom() - 5.5;
  const double x = box.center().x() - bar.length_px / 2.0;
  painter.setPen(QPen(kInk, 2.0, Qt::SolidLine, Qt::FlatCap));
  painter.drawLine(QPointF(x, y), QPointF(x + bar.length_px, y));
  painter.drawLine(QPointF(x + 1.0, y - 4.0), QPointF(x + 1.0, y + 1.0));
  painter.drawLine(QPointF(x + bar.length_px - 1.0, y - 4.0), QPointF(x + bar.length_px - 1.0, y + 1.0));
  painter.restore();
}

QRectF compassRect(const QSizeF& view) {
  const double side = std::clamp(std::min(view.width(), view.height()) * 0.12, 24.0, 38.0);  // a small map needs room
  return QRectF(view.width() - side - 8.0, 8.0, side, side);
}

void paintCompass(QPainter& painter, const QSizeF& view, double rotation_rad, bool hovered) {
  constexpr double kEdge = 1.0;  // of the pen, outside the box
  const QRectF box = compassRect(view);
  const int degrees = static_cast<int>(std::lround(rotation_rad * 180.0 / kPi)) % 360;
  const QSizeF size = box.size() + 2.0 * QSizeF(kEdge, kEdge);
  const QString key = QStringLiteral("compass%1_%2_%3").arg(degrees).arg(hovered).arg(box.width());
  const QPixmap compass = sprite::findOrMake(key, size, deviceRatio(painter), [&](QPainter& on_sprite) {
    QPainterPath rim;
    rim.addEllipse(QRectF(QPointF(kEdge, kEdge), box.size()));
    sprite::fillAtOnce(on_sprite, rim, kPanel);
    on_sprite.strokePath(rim, QPen(hovered ? attentionColor() : kRim, hovered ? 2.0 : 1.0));
    on_sprite.translate(size.width() / 2.0, size.height() / 2.0);
    on_sprite.rotate(-degrees);
    on_sprite.scale(box.width() / 38.0, box.width() / 38.0);
    QPainterPath needle;
    needle.moveTo(0.0, -14.0);
    needle.lineTo(5.0, 0.0);
    needle.lineTo(-5.0, 0.0);
    needle.closeSubpath();
    on_sprite.fillPath(needle, QColor(0xc6, 0x28, 0x28));
    on_sprite.rotate(180.0);
    on_sprite.fillPath(needle, QColor(0x90, 0x95, 0x9b));
  });
  painter.drawPixmap(box.topLeft() - QPointF(kEdge, kEdge), compass);
}

void paintChip(QPainter& painter, const QPointF& top_middle, const QString& text, const QColor& color,
               double most_width_px) {
  QFont font = painter.font();
  font.setBold(true);
  const QFontMetricsF metrics(font);
  const QRectF text_rect = metrics.boundingRect(QRectF(0, 0, std::max(60.0, most_width_px - 24.0), 1000.0),
                                                Qt::AlignCenter | Qt::TextWordWrap, text);
  const QRectF box(1.0, 1.0, text_rect.width() + 24.0, text_rect.height() + 12.0);  // a pixel is for the pen
  const QString key = QStringLiteral("chip%1_%2_%3_%4")
                          .arg(color.name(QColor::HexArgb), font.key(), QString::number(box.width()), text);
  const QPixmap chip =
      sprite::findOrMake(key, box.size() + QSizeF(2.0, 2.0), deviceRatio(painter), [&](QPainter& on_sprite) {
        QPainterPath path;
        path.addRoundedRect(box, 9.0, 9.0);
        sprite::fillAtOnce(on_sprite, path, color);
        on_sprite.strokePath(path, QPen(QColor(235, 236, 238), 1.5));
        on_sprite.setFont(font);
        on_sprite.setPen(Qt::white);
        on_sprite.drawText(box.adjusted(12.0, 6.0, -12.0, -6.0), Qt::AlignCenter | Qt::TextWordWrap, text);
      });
  painter.drawPixmap(top_middle - QPointF(box.center().x(), 1.0), chip);
}

void paintAttentionFrame(QPainter& painter, const QSizeF& view, const QColor& color) {
  painter.save();
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(Qt::white, 7.0, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
  painter.drawRect(QRectF(QPointF(0, 0), view));
  painter.setPen(QPen(color, 8.0, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
  painter.drawRect(QRectF(QPointF(0, 0), view));
  painter.restore();
}

void paintCrosshair(QPainter& painter, const QSizeF& view, const QPointF& at) {
  painter.save();
  constexpr double kGap = 9.0;
  const QLineF lines[] = {{0, at.y(), at.x() - kGap, at.y()},
                          {at.x() + kGap, at.y(), view.width(), at.y()},
                          {at.x(), 0, at.x(), at.y() - kGap},
                          {at.x(), at.y() + kGap, at.x(), view.height()}};
  painter.setPen(QPen(QColor(255, 255, 255, 200), 3.0));
  painter.drawLines(lines, 4);
  painter.setPen(QPen(QColor(0, 0, 0, 220), 1.0));
  painter.drawLines(lines, 4);
  painter.restore();
}

void paintEmpty(QPainter& painter, const QSizeF& view, const QString& text, const QPalette& palette, EmptyLook look) {
  const bool drop_hover = look == EmptyLook::kDropHover;
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  const QColor ink = drop_hover ? attentionColor() : palette.color(QPalette::PlaceholderText);
  QPen pen(ink, drop_hover ? 3.0 : 2.0);
  pen.setDashPattern({5.0, 4.0});
  painter.setPen(pen);
  const QRectF zone = QRectF(QPointF(0, 0), view).adjusted(24, 24, -24, -24);
  if (look != EmptyLook::kText) painter.drawRoundedRect(zone, 12.0, 12.0);
  QFont font = painter.font();
  font.setPointSizeF(font.pointSizeF() * 1.15);
  painter.setFont(font);
  painter.setPen(palette.color(drop_hover ? QPalette::Active : QPalette::Inactive, QPalette::WindowText));
  painter.drawText(zone.adjusted(16, 16, -16, -16), Qt::AlignCenter | Qt::TextWordWrap, text);
  painter.restore();
}

void paintFocus(QPainter& painter, const QSizeF& view, const QColor& color) {
  painter.save();
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(color, 2.0));
  painter.drawRect(QRectF(QPointF(1, 1), view - QSizeF(2, 2)));
  painter.restore();
}

}  // namespace cad2slam::decoration
