// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QTest>
#include <QWheelEvent>

#include "ui/convert.h"
#include "ui/support/rasters.h"
#include "ui/views/map_view.h"

namespace cad2slam::test {

inline constexpr double kShownResolution = 0.05;  // [m] for each pixel of a shown view's raster

/// A shown view over a plain raster with a turned, shifted frame.
class Shown {
 public:
  explicit Shown(const cv::Mat& pixels = cv::Mat(600, 800, CV_8UC1, cv::Scalar(255)))
      : frame(frameOf(pixels, kShownResolution, {{-3.0, 2.0}, 0.3})) {
    view.setImage(TilePyramid::fromPixels(pixels));
    view.setFrame(frame);
    view.resize(640, 480);
    view.show();
    QVERIFY(QTest::qWaitForWindowExposed(&view));
    view.fit();
    view.setFocus();
  }
  [[nodiscard]] QPointF middle() const { return toQPointF(frame.metricFromPixel({400.0, 300.0})); }
  [[nodiscard]] QPoint at(const QPointF& point_m) const { return view.widgetFromMetres(point_m).toPoint(); }

  void wheel(const QPointF& at_px, int angle, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    QWheelEvent event(at_px, view.mapToGlobal(at_px), QPoint(), QPoint(0, angle), Qt::NoButton, modifiers,
                      Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(&view, &event);
  }
  void drag(const QPoint& from, const QPoint& to, Qt::MouseButton button = Qt::LeftButton) {
    QTest::mousePress(&view, button, {}, from);
    for (int step = 1; step <= 5; ++step) QTest::mouseMove(&view, from + (to - from) * step / 5);
    QTest::mouseRelease(&view, button, {}, to);
  }

  MapFrame frame;
  MapView view;
};

}  // namespace cad2slam::test
