// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QColor>

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "cad2slam/core/result.h"
#include "cad2slam/map/map_frame.h"
#include "cad2slam/projection/projector.h"
#include "cad2slam/projection/raster_warper.h"
#include "ui/services/tile_store.h"
#include "ui/views/preview_types.h"

namespace cad2slam {

/// A raster with its metric frame.
struct PreviewRaster {
  std::shared_ptr<TileStore> tiles;
  std::optional<MapFrame> frame;

  [[nodiscard]] bool isUsable() const { return tiles != nullptr && frame.has_value(); }
};

/// A raster that is drawn over the base through a projector.
struct PreviewLayer {
  PreviewRaster raster;
  Projector projector;
  QColor ink;
};

/// What there is to show. `direction` says how layers come to the base: kToBlueprint when the base is the blueprint.
struct PreviewScene {
  PreviewRaster base;
  WarpDirection direction = WarpDirection::kToBlueprint;
  QColor base_ink;
  std::vector<Eigen::Vector2d> anchors;  ///< enabled ones, blueprint frame [m]; for kCoverage
  std::vector<PreviewLayer> layers;      ///< the current map first; kInks draws all, everything else the first
};

struct PreviewRequest {
  std::shared_ptr<const PreviewScene> scene;
  PreviewKind kind = PreviewKind::kWarped;
  ViewState state;
  QSize size;          ///< logical pixels, margin included
  double ratio = 1.0;  ///< device pixels of the picture for each logical one
};

/// Draws the part of the scene that a view shows, at its resolution. Any thread; a pure function of the request and of
/// the tiles that are loaded so far.
[[nodiscard]] Result<PreviewPicture> renderPreview(const PreviewRequest& request);

/// The metric frame of a view of this size: its pixels are the device pixels.
[[nodiscard]] Result<MapFrame> frameOfView(const ViewState& state, const QSize& size, double ratio);

}  // namespace cad2slam
