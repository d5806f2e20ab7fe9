// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/status_strip.h"

#include "ui/models/foreign_text.h"

#include <QCoreApplication>
#include <QFontDatabase>
#include <QPainter>
#include <QStatusBar>
#include <QStyle>

namespace cad2slam {

namespace {

/// A label of one line that ends in dots where it is too narrow for its text.
class CutLabel : public QLabel {
 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    const QString shown = fontMetrics().elidedText(text(), Qt::ElideRight, width());
    style()->drawItemText(&painter, rect(), Qt::AlignLeft | Qt::AlignVCenter | Qt::TextSingleLine, palette(),
                          isEnabled(), shown, foregroundRole());
  }
};

}  // namespace

StatusStrip::StatusStrip(QStatusBar& bar) : hint_(new CutLabel), readout_(new QLabel), chip_(new QToolButton) {
  hint_->setObjectName(QStringLiteral("hint"));
  hint_->setTextFormat(Qt::PlainText);
  hint_->setAccessibleName(QCoreApplication::translate("StatusStrip", "What to do next"));
  QFont bold = hint_->font();
  bold.setBold(true);
  hint_->setFont(bold);
  hint_->setMinimumWidth(1);  // a long hint is cut, it does not widen the window
  readout_->setObjectName(QStringLiteral("readout"));
  readout_->setTextFormat(Qt::PlainText);
  readout_->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  chip_->setObjectName(QStringLiteral("solveChip"));
  chip_->setToolButtonStyle(Qt::ToolButtonTextOnly);
  chip_->setAutoRaise(true);
  bar.addWidget(hint_, 1);
  bar.addPermanentWidget(readout_);
  bar.addPermanentWidget(chip_);
  bar.setSizeGripEnabled(false);
}

void StatusStrip::setHint(const QString& hint) {
  if (hint_->text() != hint) hint_->setText(hint);
  hint_->setToolTip(asPlainText(hint));  // where the window is too narrow for it
}

void StatusStrip::setReadout(const QString& readout) {
  readout_->setText(readout);
}

void StatusStrip::setChip(const QString& text, ChipLook look) {
  // The sign in front tells the state without its colour.
  static constexpr const char16_t* kSigns[] = {u"○ ", u"◌ ", u"● ", u"■ "};
  static constexpr const char* kColors[] = {"palette(mid)", "#2a78c8", "#00796b", "#c2185b"};
  const auto at = static_cast<std::size_t>(look);
  const QString full = QString::fromUtf16(kSigns[at]) + text;
  if (chip_->text() == full) return;
  chip_->setText(full);
  if (look_ == look) return;  // style sheets are dear
  look_ = look;
  chip_->setStyleSheet(QStringLiteral("QToolButton { border: 1px solid %1; border-radius: 8px; padding: 1px 8px; "
                                      "color: palette(window-text); }")
                           .arg(QLatin1String(kColors[at])));
}

}  // namespace cad2slam
