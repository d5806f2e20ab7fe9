// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/main_window/typing.h"

#include <QAbstractItemView>

namespace cad2slam {

void finishTyping(const QWidget& window) {
  // An editor gives its text to the model as it loses the focus; the table is where the keyboard was before.
  for (QWidget* at = window.focusWidget(); at; at = at->parentWidget()) {
    auto* table = qobject_cast<QAbstractItemView*>(at);
    if (!table) continue;
    if (at != window.focusWidget()) table->setFocus();
    return;
  }
}

}  // namespace cad2slam
