// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <QWidget>

#include <functional>
#include <vector>

class QVBoxLayout;

namespace cad2slam {

enum class Severity { kNote, kWarning, kError };

/// A button beside a message that does something about it.
struct Cure {
  QString label;
  std::function<void()> run;
};

struct Message {
  QString id;  ///< a later message with the same id takes its place
  Severity severity = Severity::kNote;
  QString text;
  std::vector<Cure> cures;
  int vanishes_after_ms = 0;  ///< 0: stays until closed or removed
};

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
  [[nodiscard]] QWidget* rowOf(const Message& message);

  QVBoxLayout* layout_;
  std::vector<Message> messages_;
  std::vector<QString> dismissed_;  // id and text of group messages closed by hand
  bool unfolded_ = false;
};

}  // namespace cad2slam
