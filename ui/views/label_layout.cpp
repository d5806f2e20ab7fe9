// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/views/label_layout.h"

#include <algorithm>
#include <cmath>

namespace cad2slam {
namespace {

constexpr double kCell_px = 3.0;
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
    : columns_(static_cast<int>((view.width() + 2.0 * kBeyond_px) / kCell_px) + 1),
      rows_(static_cast<int>((view.height() + 2.0 * kBeyond_px) / kCell_px) + 1),
      taken_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), 0) {}

LabelLayout::Cells LabelLayout::cellsOf(const QRectF& area) const {
  const auto cell = [](double px, int count) {
    return static_cast<int>(std::clamp(std::floor((px + kBeyond_px) / kCell_px), 0.0, count - 1.0));
  };
  return {cell(area.left(), columns_), cell(area.top(), rows_), cell(area.right(), columns_),
          cell(area.bottom(), rows_)};
}

void LabelLayout::occupy(const QRectF& area) {
  const Cells cells = cellsOf(area);
  for (int row = cells.top; row <= cells.bottom; ++row) {
    const auto begin = taken_.begin() + static_cast<std::ptrdiff_t>(row) * columns_;
    std::fill(begin + cells.left, begin + cells.right + 1, std::uint8_t{1});
  }
}

bool LabelLayout::isFree(const QRectF& area) const {
  const Cells cells = cellsOf(area);
  for (int row = cells.top; row <= cells.bottom; ++row) {
    const auto begin = taken_.begin() + static_cast<std::ptrdiff_t>(row) * columns_;
    if (std::any_of(begin + cells.left, begin + cells.right + 1, [](std::uint8_t taken) { return taken != 0; }))
      return false;
  }
  return true;
}

std::optional<QRectF> LabelLayout::place(const QPointF& at, double reach, const QSizeF& text) {
  for (const Corner& corner : kCorners) {
    const QRectF area = areaAt(at, reach, text, corner);
    if (!isFree(area)) continue;
    occupy(area);
    return area;
  }
  return std::nullopt;
}

QRectF LabelLayout::placeAnyway(const QPointF& at, double reach, const QSizeF& text) {
  const QRectF area = areaAt(at, reach, text, kPreferred);
  occupy(area);
  return area;
}

}  // namespace cad2slam
