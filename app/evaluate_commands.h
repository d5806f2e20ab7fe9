// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "app/cli_command.h"
#include "app/evaluate_site.h"

namespace cad2slam::cli {

/// Parts of `evaluate` that live in files of their own.
void addEvaluateScansCommand(CLI::App& evaluate, const std::shared_ptr<EvaluateOptions>& options, ActionSlot& chosen);
void addEvaluateSpeedCommand(CLI::App& evaluate, const std::shared_ptr<EvaluateOptions>& options, ActionSlot& chosen);
void addEvaluateAllCommand(CLI::App& evaluate, const std::shared_ptr<EvaluateOptions>& options, ActionSlot& chosen);

}  // namespace cad2slam::cli
