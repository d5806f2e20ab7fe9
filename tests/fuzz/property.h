// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdio>
#include <cstdlib>

namespace cad2slam::fuzzing {

/// A property that holds for every input. Where it does not, the program ends, which is how a fuzzer hears of it.
inline void expect(bool holds, const char* property) {
  if (holds) return;
  std::fprintf(stderr, "violated: %s\n", property);
  std::abort();
}

}  // namespace cad2slam::fuzzing
