// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QTimer>

namespace cad2slam {

/// Whether the user is to see that something is being computed: from a sixth of a second on. What is over before would
/// only make the window flicker with every edit.
class BusyDelay : public QObject {
  Q_OBJECT

 public:
  static constexpr int kShownAfter_ms = 150;

  explicit BusyDelay(QObject* parent = nullptr);

  /// `busy` again while it is busy does not begin anew: many short pieces of work, as in a drag, are a long one.
  void setBusy(bool busy);

  [[nodiscard]] bool isShown() const { return shown_; }             ///< busy for long
  [[nodiscard]] bool isBrief() const { return timer_.isActive(); }  ///< busy, and nobody needs to know

 signals:
  void becameLong();

 private:
  QTimer timer_;
  bool shown_ = false;
};

}  // namespace cad2slam
