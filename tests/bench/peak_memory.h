// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <malloc.h>

#include <fstream>
#include <string>

namespace cad2slam::bench {

/// A line of /proc/self/status [bytes]: VmRSS now, VmHWM at most since the last resetPeakMemory().
inline double memoryBytes(const std::string& key) {
  std::ifstream status("/proc/self/status");
  std::string word;
  while (status >> word) {
    if (word != key + ":") continue;
    double kilobytes = 0.0;
    status >> kilobytes;
    return 1024.0 * kilobytes;
  }
  return 0.0;
}

/// What was freed before goes back to the system first: it would count as memory that is in use, and hide as much of
/// what the next step takes.
inline void resetPeakMemory() {
  malloc_trim(0);
  std::ofstream("/proc/self/clear_refs") << 5;
}

}  // namespace cad2slam::bench
