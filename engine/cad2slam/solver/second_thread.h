// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <future>
#include <system_error>
#include <utility>

namespace cad2slam {

/// Starts `task` on a thread of its own. Where there is no thread to be had, the future is not valid() and nothing was
/// started: the caller does it itself, one after the other.
template <class Task>
[[nodiscard]] auto onSecondThread(Task&& task) -> std::future<decltype(task())> {
  try {
    return std::async(std::launch::async, std::forward<Task>(task));
  } catch (const std::system_error&) {
    return {};
  }
}

}  // namespace cad2slam
