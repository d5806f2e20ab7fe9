// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/message_bar.h"

#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace cad2slam {
namespace {

constexpr std::size_t kShown = 2;  // more would push the views around

QString dismissalOf(const Message& message) {
  return message.id + QLatin1Char('\n') + message.text;
}

}  // namespace

MessageBar::MessageBar(QWidget* parent) : QWidget(parent), layout_(new QVBoxLayout(this)) {
  layout_->setContentsMargins(0, 0, 0, 0);
  layout_->setSpacing(1);
  setVisible(false);
  setAccessibleName(tr("Messages"));
}

void MessageBar::show(Message message) {
  std::erase_if(messages_, [&](const Message& other) { return other.id == message.id; });
  if (message.vanishes_after_ms > 0) {
    QTimer::singleShot(message.vanishes_after_ms, this, [this, id = message.id, text = message.text] {
      const auto same = [&](const Message& other) { return other.id == id && other.text == text; };
      if (std::erase_if(messages_, same) > 0) rebuild();
    });
  }
  messages_.push_back(std::move(message));
  rebuild();
}

void MessageBar::remove(const QString& id) {
  if (std::erase_if(messages_, [&](const Message& message) { return message.id == id; }) > 0) rebuild();
}

void MessageBar::showGroup(const QString& prefix, std::vector<Message> messages) {
  // What has gone away and comes back is news.
  std::erase_if(dismissed_, [&](const QString& dismissal) {
    return dismissal.startsWith(prefix) && std::none_of(messages.begin(), messages.end(), [&](const Message& message) {
             return dismissalOf(message) == dismissal;
           });
  });
  std::erase_if(messages, [&](const Message& message) {
    return std::find(dismissed_.begin(), dismissed_.end(), dismissalOf(message)) != dismissed_.end();
  });
  const auto in_group = [&](const Message& message) { return message.id.startsWith(prefix); };
  std::vector<Message> before;
  std::copy_if(messages_.begin(), messages_.end(), std::back_inserter(before), in_group);
  const auto same = [](const Message& a, const Message& b) { return a.id == b.id && a.text == b.text; };
  if (std::equal(before.begin(), before.end(), messages.begin(), messages.end(), same)) return;
  std::erase_if(messages_, in_group);
  std::move(messages.begin(), messages.end(), std::back_inserter(messages_));
  rebuild();
}

void MessageBar::rebuild() {
  while (QLayoutItem* item = layout_->takeAt(0)) {
    if (QWidget* widget = item->widget()) {
      widget->hide();
      widget->deleteLater();  // the button that was pressed may be one of them
    }
    delete item;
  }
  std::stable_sort(messages_.begin(), messages_.end(),
                   [](const Message& a, const Message& b) { return a.severity > b.severity; });
  if (messages_.size() <= kShown) unfolded_ = false;
  const std::size_t shown = unfolded_ ? messages_.size() : std::min(messages_.size(), kShown);
  for (std::size_t i = 0; i < shown; ++i) layout_->addWidget(rowOf(messages_[i]));
  if (messages_.size() > kShown) {
    auto* more = new QToolButton(this);
    more->setAutoRaise(true);
    more->setText(unfolded_ ? tr("Show fewer") : tr("%n more message(s)", nullptr, int(messages_.size() - shown)));
    connect(more, &QToolButton::clicked, this, [this] {
      unfolded_ = !unfolded_;
      rebuild();
    });
    layout_->addWidget(more);
  }
  setVisible(!messages_.empty());
}

QWidget* MessageBar::rowOf(const Message& message) {
  auto* row = new QFrame(this);
  row->setObjectName(QStringLiteral("message"));
  // One accent at the left tells the severity, and a sign says the same without colour; text keeps its normal contrast.
  static constexpr const char* kColors[] = {"#2a78c8", "#d98a00", "#c2185b"};
  static constexpr const char16_t* kSigns[] = {u"ℹ", u"▲", u"■"};
  const auto at = static_cast<std::size_t>(message.severity);
  row->setStyleSheet(QStringLiteral("#message { border: none; border-left: 5px solid %1; background: palette(base); }")
                         .arg(QLatin1String(kColors[at])));
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(10, 3, 6, 3);
  auto* sign = new QLabel(QString::fromUtf16(kSigns[at]), row);
  sign->setStyleSheet(QStringLiteral("color: %1; font-weight: bold").arg(QLatin1String(kColors[at])));
  layout->addWidget(sign);
  auto* text = new QLabel(message.text, row);
  text->setWordWrap(true);
  text->setTextInteractionFlags(Qt::TextSelectableByMouse);
  QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  policy.setHeightForWidth(true);  // or a second line is cut
  text->setSizePolicy(policy);
  layout->addWidget(text, 1);
  for (const Cure& cure : message.cures) {
    auto* button = new QPushButton(cure.label, row);
    connect(button, &QPushButton::clicked, this, [run = cure.run] { run(); });
    layout->addWidget(button);
  }
  auto* close = new QToolButton(row);
  close->setAutoRaise(true);
  close->setText(QStringLiteral("✕"));
  close->setAccessibleName(tr("Close this message"));
  close->setToolTip(tr("Close this message"));
  connect(close, &QToolButton::clicked, this, [this, message] {
    dismissed_.push_back(dismissalOf(message));
    remove(message.id);
  });
  layout->addWidget(close);
  return row;
}

}  // namespace cad2slam
