// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace cad2slam {

/// What a program with the window says to the operating system before anything else: that its window comes before its
/// work, and that it keeps freed memory. Wishes only: where one is refused, the program is slower.
void setUpProcess();

}  // namespace cad2slam
