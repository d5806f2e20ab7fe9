// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/views/background_thread.h"

#include <QThreadPool>

#include <sched.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <latch>
#include <memory>

namespace cad2slam {
namespace {

/// struct sched_attr of the kernel, version 0: the C library has it since 2.41 only, and the kernel's own header cannot
/// be included beside <sched.h> of before.
struct SchedulingWish {
  std::uint32_t size = sizeof(SchedulingWish);
  std::uint32_t policy = SCHED_OTHER;
  std::uint64_t flags = 0;
  std::int32_t nice = 0;
  std::uint32_t priority = 0;
  std::uint64_t slice_ns = 0;  // 0: what the kernel takes itself. Before Linux 6.12 it is ignored.
  std::uint64_t deadline = 0;
  std::uint64_t period = 0;
};

/// Of the calling thread. Whoever starts the program with `nice` has said how much it may take.
int ownNice() {
  return getpriority(PRIO_PROCESS, 0);
}

/// For the calling thread alone. Where it is refused, all threads are equal.
bool schedule(const SchedulingWish& wish) {
  return syscall(SYS_sched_setattr, 0, &wish, 0U) == 0;
}

}  // namespace

void giveWayToWindow() {
  constexpr int kNice = 10;  // a tenth of the processor where the window wants all of it
  thread_local const bool is_done = schedule({.nice = std::max(kNice, ownNice())});
  static_cast<void>(is_done);
}

void comeBeforeBackground() {
  constexpr std::uint64_t kSlice_ns = 1'000'000;
  static_cast<void>(schedule({.nice = ownNice(), .slice_ns = kSlice_ns}));
}

void startLastingThreads(QThreadPool& pool, int count) {
  pool.setExpiryTimeout(-1);
  // One that is done early would be given the next task: each waits until all have one.
  const auto all_run = std::make_shared<std::latch>(count);
  for (int i = 0; i < count; ++i) pool.start([all_run] { all_run->arrive_and_wait(); });
}

}  // namespace cad2slam
