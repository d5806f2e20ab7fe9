// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QColor>
#include <QImage>
#include <QPainter>
#include <QRect>
#include <QTransform>

#include <memory>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "ui/views/raster_source.h"

namespace cad2slam {

/// Draws a RasterSource through an affine map: takes the level that fits the zoom, fills tiles that are not at hand
/// from coarser ones, resamples what is visible once, and while the picture only shifts by whole device pixels draws
/// only the strips that come into view.
class RasterLayer {
 public:
  RasterLayer() = default;
  RasterLayer(const RasterLayer&) = delete;  // the picture lies in a buffer of its own layer
  RasterLayer& operator=(const RasterLayer&) = delete;

  void setSource(std::shared_ptr<RasterSource> source);
  [[nodiscard]] const std::shared_ptr<RasterSource>& source() const { return source_; }
  /// Tiles arrived: look again at those that were missing.
  void refresh() { stale_ = true; }

  /// Takes the memory for pictures of this size beforehand: where a page of it is slow to get, as in a virtual machine,
  /// that is most of what the first picture costs.
  void reserve(const QSize& device_size);

  /// Fills the rectangle (0, 0, size) of the painter, logical pixels; `background` where the raster is not.
  void paint(QPainter& painter, const QTransform& widget_from_image, const QSize& size, const QColor& background);

  /// Whether the last picture had all its tiles; where not, tilesChanged() of the source tells when to refresh.
  [[nodiscard]] bool isComplete() const { return !in_view_ || patch_complete_; }

  /// The level a raster is drawn from when one of its pixels covers `device_px` device pixels.
  [[nodiscard]] static int levelForScale(double device_px, int level_count);

 private:
  bool gatherPatch(const QTransform& device_from_image, const QSize& device_size);
  void fillTile(int column, int row);
  void resample(const QTransform& device_from_image, const QRect& device_rect, const QColor& background);

  std::shared_ptr<RasterSource> source_;
  bool stale_ = true;

  // The visible tiles of one level side by side, in a buffer that only grows.
  cv::Mat patch_buffer_;
  cv::Mat patch_;
  int patch_level_ = 0;
  QRect patch_tiles_;           // columns and rows of tiles
  bool patch_complete_ = true;  // no tile stands in for a missing one

  // The last picture, device pixels, in a buffer that only grows.
  std::vector<uchar> picture_buffer_;
  QImage picture_;
  QTransform picture_transform_;
  QColor picture_background_;
  bool picture_complete_ = false;
  bool in_view_ = true;  // some of the raster, when last painted
};

}  // namespace cad2slam
