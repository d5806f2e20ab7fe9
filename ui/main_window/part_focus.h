// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

class QWidget;

namespace cad2slam {

/// Gives the keyboard to the next of the parts of a window that can be seen, be it in a window of its own; to the first
/// where none has it.
void focusNextPart(const std::vector<QWidget*>& parts);

}  // namespace cad2slam
