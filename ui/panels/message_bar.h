// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/panels/message_row.h"

#include <QPointer>
#include <QString>
#include <QWidget>

#include <vector>

class QToolButton;
class QVBoxLayout;

namespace cad2slam {

class ToastOverlay;

/// Sentences above the views that never block: what is wrong, and the button that cures it. Pinned ones come first,
/// then the worst; more than a few are folded away. What vanishes by itself is news and never folded: the newest is
/// shown, over the lower edge of the views where there is a place for it, else among the others.
class MessageBar : public QWidget {
  Q_OBJECT

 public:
  explicit MessageBar(QWidget* parent = nullptr);

  /// Where to show what vanishes by itself, so that the views do not move for it.
  void setOverlay(ToastOverlay* overlay);
  void show(Message message);
  void remove(const QString& id);
  /// Replaces all messages whose id starts with `prefix`; one that was closed by hand stays away until its text is
  /// another.
  void showGroup(const QString& prefix, std::vector<Message> messages);
  [[nodiscard]] const std::vector<Message>& messages() const { return messages_; }

 private:
  void rebuild();
  void lay(QVBoxLayout& layout, const std::vector<const Message*>& messages, std::vector<MessageRow*>& unused);
  [[nodiscard]] MessageRow* rowFor(const Message& message, std::vector<MessageRow*>& unused);

  QVBoxLayout* layout_;
  std::vector<MessageRow*> rows_;  // as shown
  QToolButton* more_;
  QPointer<ToastOverlay> overlay_;
  std::vector<Message> messages_;
  std::vector<QString> dismissed_;  // id and text of group messages closed by hand
  bool unfolded_ = false;
};

}  // namespace cad2slam
