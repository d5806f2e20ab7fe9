// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/main_window/part_focus.h"

#include <QApplication>
#include <QWidget>

#include <algorithm>

namespace cad2slam {

void focusNextPart(const std::vector<QWidget*>& parts) {
  QWidget* focused = QApplication::focusWidget();  // maybe an editor within a part
  const auto has_keyboard = [&](QWidget* part) { return focused && (part == focused || part->isAncestorOf(focused)); };
  // Of docks that lie in one place as tabs only the one in front has a region.
  const auto is_seen = [](QWidget* part) { return part->isVisible() && !part->visibleRegion().isEmpty(); };
  std::vector<QWidget*> order = parts;
  const auto current = std::find_if(order.begin(), order.end(), has_keyboard);
  if (current != order.end()) std::rotate(order.begin(), current + 1, order.end());
  const auto next = std::find_if(order.begin(), order.end(), is_seen);
  if (next == order.end()) return;
  (*next)->window()->activateWindow();  // a dock may float
  (*next)->setFocus(Qt::TabFocusReason);
}

}  // namespace cad2slam
