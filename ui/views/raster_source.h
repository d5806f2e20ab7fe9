// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QImage>
#include <QObject>
#include <QRect>
#include <QSize>

namespace cad2slam {

/// A square piece of a raster at one level; level l is the raster reduced by 2^l, level 0 the raster itself.
struct TileKey {
  int level = 0;
  int column = 0;
  int row = 0;

  friend bool operator==(const TileKey& a, const TileKey& b) {
    return a.level == b.level && a.column == b.column && a.row == b.row;
  }
};

/// A raster of any size in tiles. What a MapView draws from; knows nothing of metres.
/// All images are Format_Grayscale8 or Format_RGB32, the same for the whole raster. Used from the GUI thread.
class RasterSource : public QObject {
  Q_OBJECT

 public:
  static constexpr int kTileSize = 256;

  using QObject::QObject;

  /// Of level 0, pixels; empty while it is not known.
  [[nodiscard]] virtual QSize size() const = 0;
  /// At least 1 when the size is known; the last level fits into one tile.
  [[nodiscard]] virtual int levelCount() const = 0;
  [[nodiscard]] virtual QImage::Format format() const = 0;

  /// Of the rows that are read so far, where that goes on in the background.
  [[nodiscard]] virtual int percentRead() const { return 100; }

  /// A tile without waiting. Null when it is not at hand: it is then fetched, and tilesChanged() tells when to ask
  /// again. Tiles on the right and bottom edge are smaller than kTileSize.
  [[nodiscard]] virtual QImage tile(const TileKey& key) = 0;

  /// A small piece (at most 512 x 512) of one level, for the loupe and for snapping. May unpack tiles; null when a part
  /// of it is not loaded yet. `rect` is clipped to the level by the caller.
  [[nodiscard]] virtual QImage pixels(int level, const QRect& rect) = 0;

  /// Size of a level, pixels: halved and rounded up, level by level.
  [[nodiscard]] QSize levelSize(int level) const {
    const int round_up = (1 << level) - 1;
    return {(size().width() + round_up) >> level, (size().height() + round_up) >> level};
  }

 signals:
  void tilesChanged();
};

}  // namespace cad2slam
