// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/solver/one_thread.h"

#include "cad2slam/core/vector_registers.h"
#include "cad2slam/solver/loaded_function.h"

namespace cad2slam {

OneThread::OneThread() {
  clearUpperVectorHalves();
  // OpenBLAS counts threads for the whole process, so this is not taken back.
  static const bool is_set = [] {
    if (auto* set_threads = loadedFunction<void(int)>("openblas_set_num_threads")) set_threads(1);
    return true;
  }();
  static_cast<void>(is_set);
  static auto* const levels = loadedFunction<int()>("omp_get_max_active_levels");
  static auto* const set_levels = loadedFunction<void(int)>("omp_set_max_active_levels");
  if (levels == nullptr || set_levels == nullptr) return;
  openmp_levels_ = levels();
  set_levels(0);  // of the calling thread
}

OneThread::~OneThread() {
  static auto* const set_levels = loadedFunction<void(int)>("omp_set_max_active_levels");
  if (set_levels != nullptr) set_levels(openmp_levels_);
}

}  // namespace cad2slam
