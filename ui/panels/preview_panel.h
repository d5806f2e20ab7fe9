// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

#include "ui/views/preview_view.h"

class QAction;
class QComboBox;
class QLabel;
class QSlider;
class QToolButton;

namespace cad2slam {

/// The preview with its controls: what is compared how, how opaque, and which map lies below.
class PreviewPanel : public QWidget {
  Q_OBJECT

 public:
  explicit PreviewPanel(QWidget* parent = nullptr);

  [[nodiscard]] PreviewView& view() { return *view_; }
  [[nodiscard]] PreviewMode mode() const { return view_->mode(); }
  /// Whether the blueprint lies below and the SLAM map above, or the other way round.
  [[nodiscard]] bool isBlueprintBelow() const { return blueprint_below_; }
  [[nodiscard]] QSize minimumSizeHint() const override;

 public slots:
  void setMode(cad2slam::PreviewMode mode);
  void nextMode();
  void changeOpacity(double by);
  void setBlueprintBelow(bool below);
  void swapDirection() { setBlueprintBelow(!blueprint_below_); }

 signals:
  void modeChanged(cad2slam::PreviewMode mode);
  void directionChanged(bool blueprint_below);

 protected:
  /// B works wherever the keyboard is, but never while something is typed.
  bool eventFilter(QObject* watched, QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void showControls();
  void fitControls();

  PreviewView* view_;
  QComboBox* modes_;
  QLabel* opacity_label_;
  QSlider* opacity_;
  QToolButton* direction_;
  int direction_words_px_ = 0;  // its width with words; 0: to be measured
  QToolButton* auto_blink_;
  QToolButton* fit_ = nullptr;
  bool blueprint_below_ = true;
};

}  // namespace cad2slam
