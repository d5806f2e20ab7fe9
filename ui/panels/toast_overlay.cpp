// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/toast_overlay.h"

#include "ui/panels/message_row.h"

#include <QEvent>
#include <QVBoxLayout>

#include <algorithm>

namespace cad2slam {
namespace {

constexpr int kWidest_px = 720;
constexpr int kMargin_px = 2;  // whole maps leave more than a line of text there

}  // namespace

ToastOverlay::ToastOverlay(QWidget& under)
    : QWidget(under.parentWidget()), under_(under), rows_(new QVBoxLayout(this)) {
  rows_->setContentsMargins(1, 1, 1, 1);
  rows_->setSpacing(1);
  setObjectName(QStringLiteral("toasts"));
  setAttribute(Qt::WA_StyledBackground);
  setStyleSheet(QStringLiteral("#toasts { background: palette(mid); }"));  // a line around the rows
  under_.installEventFilter(this);
  hide();
}

void ToastOverlay::settle() {
  setVisible(!rows_->isEmpty());
  if (rows_->isEmpty()) return;
  const QRect area = under_.geometry();
  rows_->invalidate();
  rows_->activate();
  int wanted = 0;
  for (const MessageRow* row : findChildren<MessageRow*>(QString(), Qt::FindDirectChildrenOnly))
    if (!row->isHidden()) wanted = std::max(wanted, row->widthOfOneLine() + 2);
  const int width = std::max(1, std::min({wanted, kWidest_px, area.width() - 2 * kMargin_px}));
  const int height = rows_->hasHeightForWidth() ? rows_->totalHeightForWidth(width) : rows_->totalSizeHint().height();
  setGeometry(area.center().x() - width / 2, area.bottom() - kMargin_px - height, width, height);
  raise();
}

bool ToastOverlay::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize || event->type() == QEvent::Move) settle();
  return QWidget::eventFilter(watched, event);
}

}  // namespace cad2slam
