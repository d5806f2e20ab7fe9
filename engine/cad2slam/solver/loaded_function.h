// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <dlfcn.h>

namespace cad2slam {

/// A function of a library that this process has loaded, or null: which BLAS there is, and whether CHOLMOD was built
/// with OpenMP, is the system's choice.
template <class Function>
Function* loadedFunction(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_DEFAULT, name));
}

}  // namespace cad2slam
