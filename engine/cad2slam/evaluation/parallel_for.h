// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>

namespace cad2slam {

/// Calls task(worker, index) once for each index below `count`, on up to `threads` threads (0: one for each core).
/// Workers are numbered from 0, so that each can keep a solver of its own. An exception of a task ends the others after
/// their current index and is thrown again here.
void parallelFor(std::size_t count, unsigned threads,
                 const std::function<void(unsigned worker, std::size_t index)>& task);

/// How many workers parallelFor would use.
[[nodiscard]] unsigned workerCount(std::size_t count, unsigned threads);

}  // namespace cad2slam
