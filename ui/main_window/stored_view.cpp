// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/main_window/stored_view.h"

#include "ui/views/map_view.h"

namespace cad2slam {

QJsonObject storedView(const MapView& view) {
  const ViewState state = view.viewState();
  QJsonObject stored{{QStringLiteral("rotation_rad"), state.rotation_rad}};
  if (view.isFitted()) {
    stored.insert(QStringLiteral("fitted"), true);
  } else {
    stored.insert(QStringLiteral("x_m"), state.center_m.x());
    stored.insert(QStringLiteral("y_m"), state.center_m.y());
    stored.insert(QStringLiteral("m_per_px"), state.m_per_px);
  }
  return stored;
}

void restoreView(MapView& view, const QJsonObject& stored) {
  ViewState state;
  state.center_m = {stored[u"x_m"].toDouble(), stored[u"y_m"].toDouble()};
  state.m_per_px = stored[u"m_per_px"].toDouble();
  state.rotation_rad = stored[u"rotation_rad"].toDouble();
  if (stored[u"fitted"].toBool()) {
    view.setRotation(state.rotation_rad);
    view.fit();
  } else if (state.m_per_px > 1e-6 && state.m_per_px < 1e6) {
    view.setViewState(state);
  }
}

}  // namespace cad2slam
