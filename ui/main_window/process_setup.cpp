// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/main_window/process_setup.h"

#include "cad2slam/solver/blas_kernels.h"
#include "ui/views/background_thread.h"
#include "ui/views/lane.h"

#include <QThreadPool>

#include <malloc.h>

#include <algorithm>

namespace cad2slam {
namespace {

/// A factor of 15 MB that is freed and allocated again with every edit costs up to 50 ms of page faults in a virtual
/// machine, twice as much as filling it in. Larger pieces than the first limit, such as images, are given back.
void keepFreedMemory() {
#if defined(__GLIBC__)
  constexpr int kLargestKept_bytes = 32 << 20;  // the most that glibc takes
  constexpr int kMostKept_bytes = 64 << 20;     // at the end of the heap
  mallopt(M_MMAP_THRESHOLD, kLargestKept_bytes);
  mallopt(M_TRIM_THRESHOLD, kMostKept_bytes);
#endif
}

/// Those that the first project takes: started here, they do not stop the window while it loads.
void startThreads() {
  constexpr int kOfFirstProject = 5;  // two images and what they mean, the journal
  Lane::prepareSharedThreads(kOfFirstProject);
  // Qt fills large areas with these while the window waits; without work it would end them after half a minute.
  constexpr int kMostOfQt = 4;
  QThreadPool& of_qt = *QThreadPool::globalInstance();
  startLastingThreads(of_qt, std::min(of_qt.maxThreadCount(), kMostOfQt));
}

}  // namespace

void setUpProcess() {
  fitBlasToProcessor();  // before there are threads
  comeBeforeBackground();
  keepFreedMemory();
  startThreads();
}

}  // namespace cad2slam
