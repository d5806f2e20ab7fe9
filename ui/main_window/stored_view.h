// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QJsonObject>

namespace cad2slam {

class MapView;

/// What part of a map a view shows, as a project keeps it. A view that shows the whole map does so again in a window of
/// any size.
[[nodiscard]] QJsonObject storedView(const MapView& view);
/// Leaves the view as it is where nothing was stored, or nothing that makes sense.
void restoreView(MapView& view, const QJsonObject& stored);

}  // namespace cad2slam
