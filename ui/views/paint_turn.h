// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QPainter>
#include <QRect>
#include <QWidget>

namespace cad2slam {

/// Large views that change at once, as when a project is opened, take turns: what is dear to paint is spread over
/// several frames, and in between the event loop answers mouse and keys. A view that waits keeps its old pixels, so it
/// must be opaque (Qt::WA_OpaquePaintEvent). One for each view, in the GUI thread.
class PaintTurn {
 public:
  explicit PaintTurn(QWidget& view) : view_(view) {}

  /// First thing in paintEvent(), with the painter of the view. False: paint nothing; the view is told to paint again
  /// soon. Pictures taken of the view, and one of which old pixels cannot be of use, never wait.
  [[nodiscard]] bool take(const QPainter& painter);

  /// Call it when the view is hidden: its old pixels are gone.
  void forgetPixels() { painted_ = {}; }

 private:
  QWidget& view_;
  /// Where old pixels lie and of what screen they are: they are of use as long as all of it is the same.
  struct Ground {
    QRect place;  // in the window
    QSize window;
    double device_ratio = 0.0;
    friend bool operator==(const Ground&, const Ground&) = default;
  };
  Ground painted_;
  int waited_ = 0;
};

}  // namespace cad2slam
