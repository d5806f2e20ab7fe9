// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/main_window/typing.h"

#include <QAbstractItemView>
#include <QApplication>

namespace cad2slam {

void finishTyping() {
  // An editor gives its text to the model as it loses the focus; the table is where the keyboard was before. Of the
  // program, not of a window: the table may float in one of its own.
  for (QWidget* at = QApplication::focusWidget(); at; at = at->parentWidget()) {
    auto* table = qobject_cast<QAbstractItemView*>(at);
    if (!table) continue;
    if (at != QApplication::focusWidget()) table->setFocus();
    return;
  }
}

}  // namespace cad2slam
