// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QFrame>
#include <QString>

#include <functional>
#include <optional>
#include <vector>

class QHBoxLayout;
class QLabel;
class QPushButton;

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
  bool pinned = false;        ///< comes before all others and is never folded away
};

/// One message with its buttons. Another message with the same buttons changes nothing but the words: a button that is
/// being pressed while its numbers change stays the same button.
class MessageRow : public QFrame {
  Q_OBJECT

 public:
  explicit MessageRow(QWidget* parent = nullptr);

  void setMessage(const Message& message);
  [[nodiscard]] const Message& message() const { return message_; }
  /// [px] with all words in one line.
  [[nodiscard]] int widthOfOneLine() const;

 signals:
  void closed();

 private:
  void setSeverity(Severity severity);
  void makeButtons();

  Message message_;
  std::optional<Severity> severity_;
  QHBoxLayout* layout_;
  QLabel* sign_;
  QLabel* text_;
  std::vector<QPushButton*> buttons_;
};

}  // namespace cad2slam
