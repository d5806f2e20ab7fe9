// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QColor>
#include <QPainter>
#include <QPalette>
#include <QRectF>
#include <QString>

namespace cad2slam {

/// What a view draws over its map in places of the widget, logical pixels.
namespace decoration {

/// A length of 1, 2 or 5 times a power of ten and the width it takes.
struct ScaleBar {
  double length_m = 0.0;
  double length_px = 0.0;
  QString text;
};
/// The largest of 1, 2 and 5 times a power of ten that is not above; 0 where there is none.
[[nodiscard]] double roundedDown(double value);
[[nodiscard]] ScaleBar scaleBarFor(double m_per_px, double most_px);

void paintScaleBar(QPainter& painter, const QSizeF& view, double m_per_px);

/// The round handle at the top right that shows and turns the rotation of the view.
[[nodiscard]] QRectF compassRect(const QSizeF& view);
void paintCompass(QPainter& painter, const QSizeF& view, double rotation_rad, bool hovered);

/// A rounded box with a text; wrapped to a width.
void paintChip(QPainter& painter, const QPointF& top_middle, const QString& text, const QColor& color,
               double most_width_px);
void paintAttentionFrame(QPainter& painter, const QSizeF& view, const QColor& color);
void paintCrosshair(QPainter& painter, const QSizeF& view, const QPointF& at);
/// Where a map would be: a drop zone, or only a text.
enum class EmptyLook { kText, kDropZone, kDropHover };
void paintEmpty(QPainter& painter, const QSizeF& view, const QString& text, const QPalette& palette, EmptyLook look);
void paintFocus(QPainter& painter, const QSizeF& view, const QColor& color);

[[nodiscard]] QColor attentionColor();

}  // namespace decoration
}  // namespace cad2slam
