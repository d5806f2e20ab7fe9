// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

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

inline void resetPeakMemory() {
  std::ofstream("/proc/self/clear_refs") << 5;
}

}  // namespace cad2slam::bench
