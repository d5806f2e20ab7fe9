// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/solver/blas_kernels.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string_view>

#include "cad2slam/solver/loaded_function.h"

namespace cad2slam {
namespace {

constexpr char kVariable[] = "OPENBLAS_CORETYPE";

/// What OpenBLAS calls its best kernels for this processor, or null where those for old ones are all there is.
const char* bestKernels() {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512bw") &&
      __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl")) {
    return "SkylakeX";
  }
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return "Haswell";
#endif
  return nullptr;
}

/// Whether these are what OpenBLAS falls back to.
bool isForUnknownProcessors(std::string_view kernels) {
  constexpr std::array<std::string_view, 4> kFallbacks = {"Prescott", "Nehalem", "Sandybridge", "Barcelona"};
  return std::find(kFallbacks.begin(), kFallbacks.end(), kernels) != kFallbacks.end();
}

}  // namespace

void fitBlasToProcessor() {
  auto* const name_of_kernels = loadedFunction<char*()>("openblas_get_corename");
  auto* const forget_kernels = loadedFunction<void()>("gotoblas_dynamic_quit");
  auto* const choose_kernels = loadedFunction<void()>("gotoblas_dynamic_init");
  const char* const best = bestKernels();
  if (name_of_kernels == nullptr || forget_kernels == nullptr || choose_kernels == nullptr || best == nullptr) return;
  if (std::getenv(kVariable) != nullptr || !isForUnknownProcessors(name_of_kernels())) return;
  if (setenv(kVariable, best, 1) != 0) return;
  forget_kernels();
  choose_kernels();
  unsetenv(kVariable);  // programs that we start choose for themselves
}

}  // namespace cad2slam
