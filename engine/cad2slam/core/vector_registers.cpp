// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/core/vector_registers.h"

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace cad2slam {

#if defined(__x86_64__)

namespace {

__attribute__((target("avx"))) void clearWithAvx() {
  _mm256_zeroupper();
}

}  // namespace

void clearUpperVectorHalves() {
  if (__builtin_cpu_supports("avx")) clearWithAvx();
}

#else

void clearUpperVectorHalves() {}

#endif

}  // namespace cad2slam
