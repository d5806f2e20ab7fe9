// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>

#include "app/cli_command.h"

namespace cad2slam::cli {

/// `export keepout` and `export speed`: masks for nav2's costmap filters.
void addMaskExports(CLI::App& parent, ActionSlot& chosen);

}  // namespace cad2slam::cli
