// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QPainter>
#include <QPainterPath>
#include <QPixmap>
#include <QPixmapCache>
#include <QSizeF>
#include <QString>

#include <optional>

namespace cad2slam {

/// Small pictures that are drawn again and again are kept in QPixmapCache, for all views together.
///
/// Apart from the time to draw, that spares waiting: Qt fills translucent shapes of some size with threads of its own,
/// and those get their turn late while a solve keeps all processors busy. Opaque ones it fills at once.
namespace sprite {

inline QString fullKey(const QString& key, double ratio) {
  return QStringLiteral("cad2slam_%1_").arg(qRound(ratio * 100)) + key;
}

/// Fills with a translucent color what nothing has been drawn on yet: in one go, without threads of Qt.
inline void fillAtOnce(QPainter& painter, const QPainterPath& path, const QColor& color) {
  painter.setCompositionMode(QPainter::CompositionMode_Source);
  painter.fillPath(path, color);
  painter.setCompositionMode(QPainter::CompositionMode_SourceOver);
}

/// The one drawn before with this key for screens of `ratio` device pixels per logical pixel, if it is still there.
[[nodiscard]] inline std::optional<QPixmap> find(const QString& key, double ratio) {
  QPixmap found;
  if (!QPixmapCache::find(fullKey(key, ratio), &found)) return std::nullopt;
  return found;
}

/// A transparent picture of `size` logical pixels in which `draw(QPainter&)` has drawn; kept under `key`, which tells
/// it from all others.
template <class Draw>
[[nodiscard]] QPixmap make(const QString& key, const QSizeF& size, double ratio, const Draw& draw) {
  QPixmap picture((size * ratio).toSize());
  picture.setDevicePixelRatio(ratio);
  picture.fill(Qt::transparent);
  {
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    draw(painter);
  }
  QPixmapCache::insert(fullKey(key, ratio), picture);
  return picture;
}

template <class Draw>
[[nodiscard]] QPixmap findOrMake(const QString& key, const QSizeF& size, double ratio, const Draw& draw) {
  if (const std::optional<QPixmap> found = find(key, ratio)) return *found;
  return make(key, size, ratio, draw);
}

}  // namespace sprite
}  // namespace cad2slam
