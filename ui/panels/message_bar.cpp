// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/message_bar.h"

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
  more_ = new QToolButton;
  more_->setObjectName(QStringLiteral("moreMessages"));
  more_->setAutoRaise(true);
  more_->hide();
  connect(more_, &QToolButton::clicked, this, [this] {
    unfolded_ = !unfolded_;
    rebuild();
  });
  layout_->addWidget(more_);
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

MessageRow* MessageBar::rowFor(const Message& message, std::vector<MessageRow*>& unused) {
  const auto before = std::find_if(unused.begin(), unused.end(),
                                   [&](const MessageRow* row) { return row->message().id == message.id; });
  MessageRow* row = nullptr;
  if (before != unused.end()) {
    row = *before;
    unused.erase(before);
  } else {
    row = new MessageRow(this);
    connect(row, &MessageRow::closed, this, [this, row] {
      const QString id = row->message().id;
      dismissed_.push_back(dismissalOf(row->message()));
      remove(id);
    });
  }
  row->setMessage(message);
  return row;
}

void MessageBar::rebuild() {
  std::stable_sort(messages_.begin(), messages_.end(),
                   [](const Message& a, const Message& b) { return a.severity > b.severity; });
  if (messages_.size() <= kShown) unfolded_ = false;
  const std::size_t shown = unfolded_ ? messages_.size() : std::min(messages_.size(), kShown);
  std::vector<MessageRow*> unused = std::exchange(rows_, {});
  for (std::size_t i = 0; i < shown; ++i) {
    rows_.push_back(rowFor(messages_[i], unused));
    const QLayoutItem* there = layout_->itemAt(static_cast<int>(i));
    if (!there || there->widget() != rows_.back()) layout_->insertWidget(static_cast<int>(i), rows_.back());
  }
  for (MessageRow* row : unused) {
    row->hide();
    layout_->removeWidget(row);
    row->deleteLater();  // the button that was pressed may be in it
  }
  if (messages_.size() > kShown)
    more_->setText(unfolded_ ? tr("Show fewer") : tr("%n more message(s)", nullptr, int(messages_.size() - shown)));
  more_->setVisible(messages_.size() > kShown);
  setVisible(!messages_.empty());
}

}  // namespace cad2slam
