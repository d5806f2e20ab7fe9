// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/message_row.h"

#include "ui/models/foreign_text.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>

#include <algorithm>
#include <utility>

namespace cad2slam {

MessageRow::MessageRow(QWidget* parent)
    : QFrame(parent), layout_(new QHBoxLayout(this)), sign_(new QLabel), text_(new QLabel) {
  setObjectName(QStringLiteral("message"));
  layout_->setContentsMargins(10, 3, 6, 3);
  layout_->addWidget(sign_);
  text_->setTextFormat(Qt::PlainText);  // names and paths in it may look like HTML
  text_->setWordWrap(true);
  text_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  policy.setHeightForWidth(true);  // or a second line is cut
  text_->setSizePolicy(policy);
  layout_->addWidget(text_, 1);
  auto* close = new QToolButton;
  close->setObjectName(QStringLiteral("closeMessage"));
  close->setAutoRaise(true);
  close->setText(QStringLiteral("✕"));
  close->setAccessibleName(tr("Close this message"));
  close->setToolTip(tr("Close this message"));
  connect(close, &QToolButton::clicked, this, &MessageRow::closed);
  layout_->addWidget(close);
}

void MessageRow::setMessage(const Message& message) {
  const auto same_label = [](const Cure& a, const Cure& b) { return a.label == b.label; };
  const bool same_buttons =
      std::equal(message.cures.begin(), message.cures.end(), message_.cures.begin(), message_.cures.end(), same_label);
  message_ = message;
  setSeverity(message.severity);
  constexpr qsizetype kMostLetters = 1500;  // a file can have written any number of them
  const QString text = shortened(message.text, kMostLetters);
  if (text_->text() != text) text_->setText(text);
  if (!same_buttons) makeButtons();
}

int MessageRow::widthOfOneLine() const {
  constexpr int kSlack_px = 8;  // of the label around its words
  const int words = text_->fontMetrics().horizontalAdvance(text_->text()) + kSlack_px;
  return sizeHint().width() - text_->sizeHint().width() + words;
}

void MessageRow::setSeverity(Severity severity) {
  if (severity_ == severity) return;
  severity_ = severity;
  // One accent at the left tells the severity, and a sign says the same without colour; text keeps its normal contrast.
  static constexpr const char* kColors[] = {"#2a78c8", "#d98a00", "#c2185b"};
  static constexpr const char16_t* kSigns[] = {u"ℹ", u"▲", u"■"};
  const auto at = static_cast<std::size_t>(severity);
  setStyleSheet(QStringLiteral("#message { border: none; border-left: 5px solid %1; background: palette(base); }")
                    .arg(QLatin1String(kColors[at])));
  sign_->setText(QString::fromUtf16(kSigns[at]));
  sign_->setStyleSheet(QStringLiteral("color: %1; font-weight: bold").arg(QLatin1String(kColors[at])));
}

void MessageRow::makeButtons() {
  for (QPushButton* button : std::exchange(buttons_, {})) {
    button->hide();
    button->disconnect(this);
    layout_->removeWidget(button);
    button->deleteLater();  // it may be the one that was pressed
  }
  for (std::size_t i = 0; i < message_.cures.size(); ++i) {
    buttons_.push_back(new QPushButton(shortened(message_.cures[i].label)));
    connect(buttons_.back(), &QPushButton::clicked, this, [this, i] {
      const auto run = message_.cures[i].run;  // which may well put another message here
      run();
    });
    layout_->insertWidget(2 + static_cast<int>(i), buttons_.back());  // after sign and text
  }
}

}  // namespace cad2slam
