// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/main_window/clear_boxes.h"

#include <QApplication>
#include <QPainter>
#include <QPainterPath>
#include <QPalette>
#include <QStyleOption>

#include <algorithm>

namespace cad2slam {

ClearBoxes::ClearBoxes() : QProxyStyle(QStringLiteral("Fusion")) {
  setObjectName(QStringLiteral("fusion"));
}

void ClearBoxes::drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                               const QWidget* widget) const {
  if (element != PE_IndicatorCheckBox && element != PE_IndicatorItemViewItemCheck)
    return QProxyStyle::drawPrimitive(element, option, painter, widget);
  const QPalette palette = QApplication::palette();  // not that of a selected row
  const bool usable = option->state.testFlag(State_Enabled);
  const QColor ink = palette.color(usable ? QPalette::Active : QPalette::Disabled, QPalette::Text);
  const QColor frame = usable ? palette.color(QPalette::PlaceholderText) : ink;
  const double side = std::min(option->rect.width(), option->rect.height()) - 2.0;
  QRectF box(0.0, 0.0, side, side);
  box.moveCenter(QRectF(option->rect).center());
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  painter->setBrush(palette.color(option->state.testFlag(State_Sunken) ? QPalette::AlternateBase : QPalette::Base));
  painter->setPen(QPen(frame, 1.4));
  painter->drawRoundedRect(box, 2.0, 2.0);
  QPainterPath mark;
  if (option->state.testFlag(State_On)) {
    mark.moveTo(box.left() + 0.22 * side, box.top() + 0.52 * side);
    mark.lineTo(box.left() + 0.42 * side, box.top() + 0.73 * side);
    mark.lineTo(box.left() + 0.78 * side, box.top() + 0.27 * side);
  } else if (option->state.testFlag(State_NoChange)) {
    mark.moveTo(box.left() + 0.25 * side, box.center().y());
    mark.lineTo(box.right() - 0.25 * side, box.center().y());
  }
  painter->strokePath(mark, QPen(ink, 0.15 * side, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter->restore();
}

}  // namespace cad2slam
