// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/panels/message_row.h"

#include <QString>
#include <QWidget>

#include <vector>

class QToolButton;
class QVBoxLayout;

namespace cad2slam {

/// Sentences above the views that never block: what is wrong, and the button that cures it. The worst come first; more
/// than a few are folded away.
class MessageBar : public QWidget {
  Q_OBJECT

 public:
  explicit MessageBar(QWidget* parent = nullptr);

  void show(Message message);
  void remove(const QString& id);
  /// Replaces all messages whose id starts with `prefix`; one that was closed by hand stays away until its text is
  /// another.
  void showGroup(const QString& prefix, std::vector<Message> messages);
  [[nodiscard]] const std::vector<Message>& messages() const { return messages_; }

 private:
  void rebuild();
  [[nodiscard]] MessageRow* rowFor(const Message& message, std::vector<MessageRow*>& unused);

  QVBoxLayout* layout_;
  std::vector<MessageRow*> rows_;  // as shown
  QToolButton* more_;
  std::vector<Message> messages_;
  std::vector<QString> dismissed_;  // id and text of group messages closed by hand
  bool unfolded_ = false;
};

}  // namespace cad2slam
