// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QLabel>
#include <QString>
#include <QToolButton>

#include <optional>

class QStatusBar;

namespace cad2slam {

enum class ChipLook { kIdle, kBusy, kGood, kBad };

/// The status bar: what to do next, where the cursor is, and how the solve stands.
class StatusStrip {
 public:
  explicit StatusStrip(QStatusBar& bar);

  void setHint(const QString& hint);
  void setReadout(const QString& readout);
  void setChip(const QString& text, ChipLook look);
  [[nodiscard]] QString hint() const { return hint_->text(); }
  [[nodiscard]] QString chipText() const { return chip_->text(); }
  [[nodiscard]] QToolButton* chip() const { return chip_; }

 private:
  QLabel* hint_;
  QLabel* readout_;
  QToolButton* chip_;
  std::optional<ChipLook> look_;
};

}  // namespace cad2slam
