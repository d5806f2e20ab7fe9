// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

#include "cad2slam/core/result.h"

namespace cad2slam::cli {

/// Answers one line, given without its end, by appending to `out`.
using LineHandler = std::function<void(std::string_view line, std::string& out)>;

struct LineLimits {
  std::size_t longest_line = std::size_t{16} << 20;     ///< [bytes] a longer one ends its connection
  std::size_t largest_backlog = std::size_t{64} << 20;  ///< [bytes] unread answers; until then no more is read
  std::size_t most_connections = 64;
  std::string too_long = "the line is too long\n";  ///< last answer to who sends one
};

/// Answers standard input on standard output until it ends. Answers are written when no further whole line is there,
/// so that batches cost few calls and nobody waits for an answer that is ready.
[[nodiscard]] Result<void> serveStandardInput(const LineHandler& handler, const LineLimits& limits);

/// Listens on a Unix socket, which only its owner may connect to, until SIGINT or SIGTERM; then takes it away again.
/// One thread for all connections; what one of them sends can end that one only. A socket that a dead server left
/// behind is replaced, a living one is not. `ready` is called once when clients can connect.
[[nodiscard]] Result<void> serveUnixSocket(const std::string& path, const LineHandler& handler,
                                           const LineLimits& limits, const std::function<void()>& ready);

}  // namespace cad2slam::cli
