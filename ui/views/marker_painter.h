// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QFont>
#include <QPainter>
#include <QPixmap>

#include "ui/views/marker.h"

namespace cad2slam {

/// Colour of a class; the shape differs as well.
[[nodiscard]] QColor colorOf(MarkerClass judged);

/// Small or a dot where markers crowd, enlarged under the cursor.
enum class MarkerSize { kDot, kSmall, kNormal, kEnlarged };

/// Draws what lies on a map at places given in logical pixels of a view. Everything has a white and a dark edge, so
/// that it can be read on any raster. Markers and texts are kept as sprites in QPixmapCache, for all views together:
/// hundreds cost little.
class MarkerPainter {
 public:
  /// Draws beforehand what the first anchors of a map need: their numbers, in the classes most of them have.
  void prepare(const QPainter& painter);
  /// The shape alone.
  void paintMarker(QPainter& painter, const Marker& marker, const QPointF& at, MarkerSize size);
  /// The text of a marker, in an area of textSize() that somebody has found for it.
  void paintLabel(QPainter& painter, const Marker& marker, const QRectF& area);
  /// The same to the upper right of a marker of normal size.
  void paintLabel(QPainter& painter, const Marker& marker, const QPointF& at);
  [[nodiscard]] QSizeF textSize(const QPainter& painter, const Marker& marker);
  /// What no text may cover.
  [[nodiscard]] static QRectF coreOf(const QPointF& at, MarkerSize size);
  /// How far from the middle of a marker its text begins, in x and y.
  [[nodiscard]] static double labelReach(const Marker& marker, MarkerSize size);
  /// The text is to the right of it, or to the left where the view ends.
  void paintGhost(QPainter& painter, const QPointF& at, double radius_px, const QString& text, double view_width_px);
  void paintResidual(QPainter& painter, const QPointF& from, const QPointF& to, MarkerClass judged);
  void paintPose(QPainter& painter, const PoseGlyph& pose, const QPointF& at, double heading_on_screen_rad,
                 double radius_px, bool enlarged);
  /// A pose among hundreds: a short line with its heading.
  void paintPoseTick(QPainter& painter, const PoseGlyph& pose, const QPointF& at, double heading_on_screen_rad);
  void paintPath(QPainter& painter, const PathGlyph& path, const QTransform& widget_from_metres);
  void paintPathText(QPainter& painter, const PathGlyph& path, const QTransform& widget_from_metres);
  void paintMirroredCursor(QPainter& painter, const QPointF& at, bool certain);
  void paintSnap(QPainter& painter, const QPointF& at);
  /// Text with an edge; `at` is the left end of its middle line.
  void paintText(QPainter& painter, const QPointF& at, const QString& text, const QColor& color);

  /// Of the circle a pose is drawn with, pixels.
  [[nodiscard]] static double poseRadius(double radius_px);
  /// Where the handle that turns a pose lies, relative to the pose; pixels, heading on screen (y down, clockwise).
  [[nodiscard]] static QPointF turnHandle(double radius_px, double heading_on_screen_rad);

 private:
  enum class TextPart { kDarkEdge, kLightEdge, kInk };
  [[nodiscard]] static QPixmap markerSprite(const Marker& marker, MarkerSize size, double ratio);
  [[nodiscard]] QPixmap letterSprite(const QString& letter, TextPart part, const QColor& color, double ratio) const;
  [[nodiscard]] QPixmap textSprite(const QString& text, const QColor& color, double ratio) const;
  [[nodiscard]] QPixmap words(const QPainter& painter, const QString& text, const QColor& color);
  void useFont(const QFont& font);

  QFont font_;        // of the painter, as last seen
  QFont bold_;        // the same, for texts
  QString bold_key_;  // slow to make
};

}  // namespace cad2slam
