// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>

#include <cstdio>
#include <exception>
#include <filesystem>
#include <iostream>
#include <new>
#include <string>
#include <system_error>

#include "app/cli_command.h"
#include "app/version.h"
#include "cad2slam/solver/blas_kernels.h"

namespace {

constexpr int kFailure = 1;
constexpr int kUsage = 2;

/// What a command writes may not be a file that it reads: nobody means to replace it by something else.
cad2slam::Result<void> checkOutput(const CLI::App& app) {
  const CLI::App* command = &app;
  while (!command->get_subcommands().empty()) command = command->get_subcommands().front();
  const CLI::Option* output = command->get_option_no_throw("--output");
  if (output == nullptr || output->empty()) return {};
  const std::string target = output->results().front();
  for (const CLI::Option* option : command->get_options()) {
    if (option == output) continue;
    for (const std::string& input : option->results()) {
      std::error_code one_is_missing;
      if (std::filesystem::equivalent(target, input, one_is_missing)) {
        return cad2slam::fail(cad2slam::ErrorCode::kUnwritable, "is read by this command; give the output another name",
                              target);
      }
    }
  }
  return {};
}

int runCli(int argc, char** argv) {
  using namespace cad2slam::cli;
  CLI::App app("Projects poses between a building's blueprint and the SLAM maps of robots", "cad2slam-cli");
  app.set_version_flag("--version", std::string("cad2slam-cli ") + cad2slam::kVersion);
  app.require_subcommand(1);
  ActionSlot chosen;
  addSolveCommand(app, chosen);
  addProjectCommand(app, chosen);
  addInfoCommand(app, chosen);
  addWarpCommand(app, chosen);
  addPreviewCommand(app, chosen);
  addConvertCommand(app, chosen);
  addExportCommand(app, chosen);
  addServeCommand(app, chosen);
  addPlanCommand(app, chosen);
  addEvaluateCommand(app, chosen);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : kUsage;
  }
  cad2slam::Result<void> done = checkOutput(app);
  if (done) done = chosen.run();
  if (!done) {
    std::cout.flush();
    std::cerr << "cad2slam-cli: " << done.error().sentence() << '\n';
    return kFailure;
  }
  std::cout.flush();
  // Commands print through both; of a write that failed before, only these marks are left.
  if (!std::cout || std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
    std::cerr << "cad2slam-cli: the output could not be written\n";
    return kFailure;
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  cad2slam::fitBlasToProcessor();
  try {
    return runCli(argc, argv);
  } catch (const std::bad_alloc&) {
    std::cerr << "cad2slam-cli: not enough memory\n";
  } catch (const std::exception& error) {
    std::cerr << "cad2slam-cli: internal error: " << error.what() << '\n';
  }
  return kFailure;
}
