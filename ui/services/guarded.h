// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cad2slam/core/result.h"

#include <exception>
#include <new>
#include <type_traits>
#include <utility>

namespace cad2slam {

/// Runs `work`, which returns a Result, and turns anything thrown into ErrorCode::kInternal. For the entry of workers
/// and of the program: an exception must neither kill the window nor end in another thread.
template <class Work>
[[nodiscard]] std::invoke_result_t<Work> guarded(Work&& work) {
  try {
    return std::forward<Work>(work)();
  } catch (const std::bad_alloc&) {
    return fail(ErrorCode::kInternal, "There is not enough memory for this; use larger cells or a smaller image");
  } catch (const std::exception& thrown) {
    return fail(ErrorCode::kInternal, std::string("Something went wrong inside the program: ") + thrown.what());
  } catch (...) {
    return fail(ErrorCode::kInternal, "Something went wrong inside the program");
  }
}

}  // namespace cad2slam
