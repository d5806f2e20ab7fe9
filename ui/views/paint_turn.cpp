// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/views/paint_turn.h"

#include <QBackingStore>
#include <QCoreApplication>
#include <QElapsedTimer>
#include <QGuiApplication>
#include <QPaintEngine>

namespace cad2slam {
namespace {

constexpr qint64 kEnough_ms = 3;  // a quarter of a frame: the rest is for a view that has begun before it was over
constexpr int kLongestWait = 3;   // turns; also a view beside one that is always dear gets its turn

/// Since the first view was painted in this turn of the event loop; invalid before.
QElapsedTimer& sinceFirstView() {
  static QElapsedTimer timer;
  return timer;
}

/// Whether what a view does not paint stays as it is. A Wayland client draws into changing buffers.
bool keepsPixels() {
  static const bool kept = QGuiApplication::platformName() == QStringLiteral("xcb") ||
                           QGuiApplication::platformName() == QStringLiteral("offscreen");
  return kept;
}

}  // namespace

bool PaintTurn::take(const QPainter& painter) {
  const QBackingStore* screen = view_.backingStore();
  const bool on_screen =
      screen && painter.paintEngine() &&
      painter.paintEngine()->paintDevice() == const_cast<QBackingStore*>(screen)->paintDevice();  // has no const twin
  if (!on_screen || !keepsPixels()) return true;

  const Ground ground{QRect(view_.mapTo(view_.window(), QPoint()), view_.size()), view_.window()->size(),
                      view_.devicePixelRatioF()};
  QElapsedTimer& turn = sinceFirstView();
  if (!turn.isValid()) {
    turn.start();
    QMetaObject::invokeMethod(
        QCoreApplication::instance(), [] { sinceFirstView().invalidate(); }, Qt::QueuedConnection);
  } else if (turn.elapsed() >= kEnough_ms && waited_ < kLongestWait && painted_ == ground) {
    ++waited_;
    QMetaObject::invokeMethod(&view_, qOverload<>(&QWidget::update), Qt::QueuedConnection);
    return false;
  }
  waited_ = 0;
  painted_ = ground;
  return true;
}

}  // namespace cad2slam
