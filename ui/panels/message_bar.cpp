// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/message_bar.h"

#include "ui/panels/toast_overlay.h"

#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <tuple>
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

void MessageBar::setOverlay(ToastOverlay* overlay) {
  overlay_ = overlay;
  rebuild();
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

void MessageBar::lay(QVBoxLayout& layout, const std::vector<const Message*>& messages,
                     std::vector<MessageRow*>& unused) {
  for (std::size_t i = 0; i < messages.size(); ++i) {
    MessageRow* row = rowFor(*messages[i], unused);
    rows_.push_back(row);
    const QLayoutItem* there = layout.itemAt(static_cast<int>(i));
    if (!there || there->widget() != row) layout.insertWidget(static_cast<int>(i), row);
    row->show();
  }
}

void MessageBar::rebuild() {
  const auto vanishes = [](const Message& message) { return message.vanishes_after_ms > 0; };
  // The last one shown is the newest.
  const auto newest = std::find_if(messages_.rbegin(), messages_.rend(), vanishes);
  const Message* toast = newest == messages_.rend() ? nullptr : &*newest;
  std::vector<const Message*> above;
  for (const Message& message : messages_)
    if (!overlay_ || !vanishes(message)) above.push_back(&message);
  const auto rank = [&](const Message* message) {
    return std::tuple(message->pinned, message == toast, message->severity);
  };
  std::stable_sort(above.begin(), above.end(), [&](const Message* a, const Message* b) { return rank(a) > rank(b); });
  const std::size_t count = above.size();
  if (count <= kShown) unfolded_ = false;
  if (!unfolded_ && count > kShown) above.erase(above.begin() + kShown, above.end());
  const std::vector<const Message*> over = overlay_ && toast ? std::vector{toast} : std::vector<const Message*>();

  std::vector<MessageRow*> unused = std::exchange(rows_, {});
  lay(*layout_, above, unused);
  if (overlay_) lay(overlay_->rows(), over, unused);
  for (MessageRow* row : unused) {
    row->hide();
    layout_->removeWidget(row);
    if (overlay_) overlay_->rows().removeWidget(row);
    row->deleteLater();  // the button that was pressed may be in it
  }
  if (count > kShown)
    more_->setText(unfolded_ ? tr("Show fewer") : tr("%n more message(s)", nullptr, int(count - above.size())));
  more_->setVisible(count > kShown);
  setVisible(count > 0);
  if (overlay_) overlay_->settle();
}

}  // namespace cad2slam
