// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/views/preview_legend.h"

#include <algorithm>

#include <QFontMetricsF>
#include <QLinearGradient>
#include <QLocale>
#include <QPainter>
#include <QPainterPath>
#include <QStringList>

#include "ui/views/mesh_layer.h"
#include "ui/views/sprite_cache.h"

namespace cad2slam {
namespace {

constexpr double kEdge_px = 9.0;
constexpr double kSwatch_px = 18.0;
constexpr double kLeastRamp_px = 170.0;
const QColor kFold(0xff, 0xeb, 0x3b);
const QColor kInk(25, 28, 32);
const QColor kFaintInk(90, 96, 104);

QFont boldOf(QFont font) {
  font.setBold(true);
  return font;
}

double indentOf(const PreviewLegend::Row& row) {
  return row.color.isValid() ? kSwatch_px : 0.0;
}

/// Everything that is seen.
QString keyOf(const PreviewLegend& legend) {
  QStringList parts{legend.title, legend.hint};
  if (legend.ramp) parts << QString::number(legend.ramp->one_sided) << legend.ramp->low << legend.ramp->high;
  for (const PreviewLegend::Row& row : legend.rows) parts << row.color.name() << row.text;
  return parts.join(QChar(0x1f));
}

QSizeF sizeOf(const PreviewLegend& legend, const QFont& font, double line) {
  const QFontMetricsF metrics(font);
  double width =
      std::max(QFontMetricsF(boldOf(font)).horizontalAdvance(legend.title), metrics.horizontalAdvance(legend.hint));
  for (const PreviewLegend::Row& row : legend.rows)
    width = std::max(width, metrics.horizontalAdvance(row.text) + indentOf(row));
  if (legend.ramp) width = std::max(width, kLeastRamp_px);
  const double lines =
      1.0 + static_cast<double>(legend.rows.size()) + (legend.hint.isEmpty() ? 0.0 : 1.0) + (legend.ramp ? 2.0 : 0.0);
  return {width + 2.0 * kEdge_px, line * lines + 10.0};
}

/// Writes from top to bottom.
class LegendPainter {
 public:
  LegendPainter(QPainter& painter, const QSizeF& size, const QFont& font, double line)
      : painter_(painter), font_(font), line_(line), left_(kEdge_px), width_(size.width() - 2.0 * kEdge_px) {
    QPainterPath panel;
    panel.addRoundedRect(QRectF(QPointF(0.5, 0.5), size - QSizeF(1.0, 1.0)), 5.0, 5.0);
    sprite::fillAtOnce(painter_, panel, QColor(255, 255, 255, 228));
    painter_.strokePath(panel, QPen(QColor(185, 185, 185), 1.0));
  }

  void writeLine(double indent, const QString& text, const QFont& font, const QColor& color) {
    painter_.setFont(font);
    painter_.setPen(color);
    const QRectF place(left_ + indent, y_, width_ - indent, line_);
    const QString shown = QFontMetricsF(font).elidedText(text, Qt::ElideRight, place.width() + 1.0);
    painter_.drawText(place, Qt::AlignLeft | Qt::AlignVCenter, shown);
    y_ += line_;
  }

  void drawRamp(const PreviewLegend::Ramp& ramp) {
    const QRectF bar(left_, y_ + 2.0, width_, line_ - 5.0);
    QLinearGradient gradient(bar.topLeft(), bar.topRight());
    for (int i = 0; i <= 10; ++i)
      gradient.setColorAt(i / 10.0, strainColor(ramp.one_sided ? i / 10.0 : i / 5.0 - 1.0, 1.0));
    painter_.fillRect(bar, gradient);
    y_ += line_;
    painter_.setFont(font_);
    painter_.setPen(kInk);
    const QRectF labels(left_, y_, width_, line_);
    painter_.drawText(labels, Qt::AlignLeft | Qt::AlignVCenter, ramp.low);
    painter_.drawText(labels, Qt::AlignHCenter | Qt::AlignVCenter, ramp.middle);
    painter_.drawText(labels, Qt::AlignRight | Qt::AlignVCenter, ramp.high);
    y_ += line_;
  }

  void drawRow(const PreviewLegend::Row& row) {
    if (row.color.isValid()) {
      const QRectF swatch(left_, y_ + 3.0, 12.0, line_ - 7.0);
      painter_.fillRect(swatch, row.color);
      painter_.setPen(QPen(QColor(0, 0, 0, 120), 1.0));
      painter_.setBrush(Qt::NoBrush);
      painter_.drawRect(swatch);
    }
    writeLine(indentOf(row), row.text, font_, kInk);
  }

 private:
  QPainter& painter_;
  const QFont& font_;
  double line_;
  double left_;
  double width_;
  double y_ = 5.0;
};

}  // namespace

PreviewLegend::Ramp PreviewLegend::bothWays(const QString& most) {
  return {false, QStringLiteral("\u2212") + most, QStringLiteral("0"), QStringLiteral("+") + most};
}

PreviewLegend PreviewLegend::ofMesh(double full_color) {
  const QString most = tr("%1 %", "per cent").arg(QLocale().toString(100.0 * full_color, 'g', 2));
  return {tr("Mesh: length against rest"), bothWays(most), {{kFold, tr("crosses: the mesh folds")}}, {}};
}

QPixmap PreviewLegend::picture(const QFont& font, double most_width, double device_ratio) const {
  const double line = QFontMetricsF(font).height() + 3.0;
  QSizeF size = sizeOf(*this, font, line);
  size.setWidth(std::min(size.width(), most_width));
  const QString key = QStringLiteral("legend%1_").arg(size.width()) + font.key() + keyOf(*this);
  return sprite::findOrMake(key, size, device_ratio, [&](QPainter& painter) {
    LegendPainter legend(painter, size, font, line);
    legend.writeLine(0.0, title, boldOf(font), kInk);
    if (ramp) legend.drawRamp(*ramp);
    for (const Row& row : rows) legend.drawRow(row);
    if (!hint.isEmpty()) legend.writeLine(0.0, hint, font, kFaintInk);
  });
}

}  // namespace cad2slam
