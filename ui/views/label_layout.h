// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QPointF>
#include <QRectF>
#include <QSizeF>

#include <cstdint>
#include <optional>
#include <vector>

namespace cad2slam {

/// Finds room for texts beside markers, so that no text covers a marker or another text: each takes the first of six
/// places that is free (the greedy rule of point-feature label placement), inside the view if it can be. Most important
/// first; what finds no room is better not drawn. Logical pixels.
class LabelLayout {
 public:
  explicit LabelLayout(const QSizeF& view);

  /// A marker, or whatever else texts keep away from.
  void occupy(const QRectF& area);

  /// Where a text of this size goes beside the marker at `at`, `reach` away from its middle in x and y; the area is
  /// taken from then on. None: there is no room.
  [[nodiscard]] std::optional<QRectF> place(const QPointF& at, double reach, const QSizeF& text);
  /// The same at the first place inside the view, free or not.
  QRectF placeAnyway(const QPointF& at, double reach, const QSizeF& text);

 private:
  [[nodiscard]] bool isFree(const QRectF& area) const;
  template <class Visit>
  void forEachCell(const QRectF& area, const Visit& visit) const;

  QRectF view_;
  int columns_;
  int rows_;
  std::vector<QRectF> taken_;
  std::vector<std::vector<std::uint32_t>> cells_;  // row by row, what of taken_ reaches into each
};

}  // namespace cad2slam
