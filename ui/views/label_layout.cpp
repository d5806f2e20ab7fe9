// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/views/label_layout.h"

#include <algorithm>
#include <cmath>

namespace cad2slam {
namespace {

constexpr double kCell_px = 40.0;
constexpr double kTextEdge_px = 4.0;  // its halo, and the frame of a view with the focus
constexpr double kBeyond_px = 120.0;  // texts of markers just outside of the view count as well

/// Beside a marker: -1, 0 or 1 to the right of its middle and below it.
struct Corner {
  int right;
  int below;
};
constexpr Corner kPreferred{1, -1};
constexpr Corner kCorners[] = {kPreferred, {1, 1}, {-1, -1}, {-1, 1}, {0, -1}, {0, 1}};

QRectF areaAt(const QPointF& at, double reach, const QSizeF& text, const Corner& corner) {
  const double half_width = text.width() / 2.0;
  // Beside the marker it need not be all above it or below.
  const double away = corner.right != 0 ? reach - 2.0 : reach + text.height() / 2.0 - 2.0;
  const QPointF middle = at + QPointF(corner.right * (reach + half_width), corner.below * away);
  return QRectF(middle - QPointF(half_width, text.height() / 2.0), text);
}

}  // namespace

LabelLayout::LabelLayout(const QSizeF& view)
    : view_(QRectF(QPointF(), view).adjusted(kTextEdge_px, kTextEdge_px, -kTextEdge_px, -kTextEdge_px)),
      columns_(static_cast<int>((view.width() + 2.0 * kBeyond_px) / kCell_px) + 1),
      rows_(static_cast<int>((view.height() + 2.0 * kBeyond_px) / kCell_px) + 1),
      cells_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {}

template <class Visit>
void LabelLayout::forEachCell(const QRectF& area, const Visit& visit) const {
  const auto cell = [](double px, int count) {
    return static_cast<int>(std::clamp(std::floor((px + kBeyond_px) / kCell_px), 0.0, count - 1.0));
  };
  for (int row = cell(area.top(), rows_); row <= cell(area.bottom(), rows_); ++row)
    for (int column = cell(area.left(), columns_); column <= cell(area.right(), columns_); ++column)
      visit(static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column));
}

void LabelLayout::occupy(const QRectF& area) {
  const auto number = static_cast<std::uint32_t>(taken_.size());
  taken_.push_back(area);
  forEachCell(area, [&](std::size_t cell) { cells_[cell].push_back(number); });
}

bool LabelLayout::isFree(const QRectF& area) const {
  bool free = true;
  forEachCell(area, [&](std::size_t cell) {
    free = free && std::none_of(cells_[cell].begin(), cells_[cell].end(),
                                [&](std::uint32_t number) { return taken_[number].intersects(area); });
  });
  return free;
}

std::optional<QRectF> LabelLayout::place(const QPointF& at, double reach, const QSizeF& text) {
  for (const bool whole : {true, false}) {  // rather cut by the edge of the view than not there
    for (const Corner& corner : kCorners) {
      const QRectF area = areaAt(at, reach, text, corner);
      if (view_.contains(area) != whole || !isFree(area)) continue;
      occupy(area);
      return area;
    }
  }
  return std::nullopt;
}

QRectF LabelLayout::placeAnyway(const QPointF& at, double reach, const QSizeF& text) {
  QRectF area = areaAt(at, reach, text, kPreferred);
  for (const Corner& corner : kCorners) {
    const QRectF other = areaAt(at, reach, text, corner);
    if (!view_.contains(other)) continue;
    area = other;
    break;
  }
  occupy(area);
  return area;
}

}  // namespace cad2slam
