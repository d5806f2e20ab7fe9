// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QPointF>
#include <QSizeF>
#include <QTransform>

namespace cad2slam {

/// What part of a metric frame a view shows, and how. A value.
struct ViewState {
  QPointF center_m;           ///< shown in the middle of the view
  double m_per_px = 0.05;     ///< metres for each logical pixel of the view, > 0
  double rotation_rad = 0.0;  ///< the frame is drawn turned counter-clockwise by this

  /// Logical pixels of a view of this size, from metres. Metres have y up, pixels have y down.
  [[nodiscard]] QTransform widgetFromMetres(const QSizeF& size_px) const;

  friend bool operator==(const ViewState& a, const ViewState& b) {
    return a.center_m == b.center_m && a.m_per_px == b.m_per_px && a.rotation_rad == b.rotation_rad;
  }
  friend bool operator!=(const ViewState& a, const ViewState& b) { return !(a == b); }
};

}  // namespace cad2slam
