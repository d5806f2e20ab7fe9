// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/views/background_thread.h"

#include <sys/resource.h>

namespace cad2slam {

void giveWayToWindow() {
  constexpr int kNice = 5;  // a third of the processor where the window wants all of it
  // In Linux, of this thread alone; where it is refused, all threads are equal.
  thread_local const int refused = setpriority(PRIO_PROCESS, 0, kNice);
  static_cast<void>(refused);
}

}  // namespace cad2slam
