// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>

#include <functional>

#include "cad2slam/core/result.h"

namespace cad2slam::cli {

/// What a subcommand does once its options are read. An error is printed as one sentence and ends with exit code 1.
using Action = std::function<Result<void>()>;

/// Keeps the action of the subcommand that the command line chose.
class ActionSlot {
 public:
  void set(Action action) { action_ = std::move(action); }
  [[nodiscard]] Result<void> run() const { return action_ ? action_() : Result<void>{}; }

 private:
  Action action_;
};

/// Each adds one subcommand with its options; the slot gets its action when the subcommand was given.
void addSolveCommand(CLI::App& app, ActionSlot& chosen);
void addProjectCommand(CLI::App& app, ActionSlot& chosen);
void addInfoCommand(CLI::App& app, ActionSlot& chosen);
void addWarpCommand(CLI::App& app, ActionSlot& chosen);
void addPreviewCommand(CLI::App& app, ActionSlot& chosen);
void addConvertCommand(CLI::App& app, ActionSlot& chosen);
void addExportCommand(CLI::App& app, ActionSlot& chosen);
void addServeCommand(CLI::App& app, ActionSlot& chosen);
void addEvaluateCommand(CLI::App& app, ActionSlot& chosen);
void addPlanCommand(CLI::App& app, ActionSlot& chosen);

}  // namespace cad2slam::cli
