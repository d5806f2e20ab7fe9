// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QPointF>

#include <optional>

#include "ui/views/raster_source.h"

namespace cad2slam {

/// The corner of drawn lines or walls nearest to a place of a raster, to a fraction of a pixel. Looks at a small window
/// only: first at `level` (the one on screen), then with finer ones around what it found.
/// `near_px` and the answer are pixels of level 0, `reach_px` too. Empty where there is no distinct corner or the
/// pixels are not loaded yet.
[[nodiscard]] std::optional<QPointF> findCorner(RasterSource& raster, const QPointF& near_px, double reach_px,
                                                int level);

}  // namespace cad2slam
