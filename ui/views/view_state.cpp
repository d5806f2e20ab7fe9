// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/views/view_state.h"

#include <cmath>

namespace cad2slam {

QTransform ViewState::widgetFromMetres(const QSizeF& size_px) const {
  const double c = std::cos(rotation_rad) / m_per_px;
  const double s = std::sin(rotation_rad) / m_per_px;
  // [x'] = [w/2] + [ c -s] [x - cx]        y' counts downwards
  // [y']   [h/2]   [-s -c] [y - cy]
  const double dx = size_px.width() / 2.0 - c * center_m.x() + s * center_m.y();
  const double dy = size_px.height() / 2.0 + s * center_m.x() + c * center_m.y();
  return QTransform(c, -s, -s, -c, dx, dy);
}

}  // namespace cad2slam
