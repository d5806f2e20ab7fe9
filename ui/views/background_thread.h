// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace cad2slam {

/// Says that the calling thread, and those it starts from now on, work for the window but must not keep it waiting:
/// where all processors are busy, painting comes first. (QThread's priorities do nothing under Linux's usual
/// scheduler.) Cheap to call again.
void giveWayToWindow();

}  // namespace cad2slam
