// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QTimer>

#include <vector>

#include "ui/views/map_view.h"
#include "ui/views/preview_legend.h"
#include "ui/views/preview_types.h"

namespace cad2slam {

/// A map with another one drawn over it in one of several ways. The other one comes as pictures from outside:
/// pictureWanted() says for which part, setPicture() brings it; until then the last one is shown in its place.
class PreviewView : public MapView {
  Q_OBJECT

 public:
  static constexpr double kMargin = 0.08;  ///< of the view, asked for on each side

  explicit PreviewView(QWidget* parent = nullptr);

  void setMode(PreviewMode mode);
  [[nodiscard]] PreviewMode mode() const { return mode_; }
  void setOpacity(double opacity);  ///< of the other map, 0 to 1
  [[nodiscard]] double opacity() const { return opacity_; }
  void setAutoBlink(bool on);
  /// While B is held: the other map in mode kBlink, the base alone in every other mode.
  void setBlinkHeld(bool held);
  [[nodiscard]] bool isBlinkHeld() const { return blink_held_; }
  void setSwipe(double part);  ///< place of the bar, 0 left to 1 right
  [[nodiscard]] double swipe() const { return swipe_; }

  void setPicture(const PreviewPicture& picture);
  void clearPicture();
  [[nodiscard]] const PreviewPicture& picture() const { return picture_; }
  /// Inks and names of the maps, the base first.
  void setInks(std::vector<InkEntry> inks);
  /// Why nothing is laid over the base, or empty.
  void setReason(const QString& reason);
  [[nodiscard]] const QString& reason() const { return reason_; }
  /// Why the picture is not that of the project as it is, or empty.
  void setNotCurrent(const QString& reason);
  /// Whether the other map lies there only roughly: an overlay is drawn faint then.
  void setRough(bool rough);

 signals:
  void swipeChanged(double part);
  void opacityChanged(double opacity);
  /// A picture of this kind for this part is wanted: new view, new size or new mode.
  void pictureWanted();

 protected:
  void paintBase(QPainter& painter) override;
  void paintOnTop(QPainter& painter) override;
  [[nodiscard]] std::optional<PreviewLegend> legend() const override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void keyReleaseEvent(QKeyEvent* event) override;
  void leaveEvent(QEvent* event) override;

 private:
  [[nodiscard]] bool isCovered() const;
  void paintPicture(QPainter& painter, double opacity);
  [[nodiscard]] std::vector<PreviewLegend::Row> legendRows() const;
  [[nodiscard]] QString legendTitle() const;
  [[nodiscard]] QString legendHint() const;
  [[nodiscard]] std::optional<PreviewLegend::Ramp> legendRamp() const;
  [[nodiscard]] bool isNearBar(const QPointF& at) const;

  PreviewMode mode_ = PreviewMode::kOverlay;
  double opacity_ = 0.5;
  double swipe_ = 0.5;
  bool dragging_bar_ = false;
  bool blink_held_ = false;
  bool blink_shows_other_ = false;
  QTimer blink_timer_;
  std::optional<QPointF> pointer_;  // where the lens is
  PreviewPicture picture_;
  std::vector<InkEntry> inks_;
  QString reason_;
  QString not_current_;
  bool rough_ = false;
};

}  // namespace cad2slam
