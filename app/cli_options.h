// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cad2slam/io/map_file.h"
#include "cad2slam/projection/projector_data.h"
#include "cad2slam/projection/raster_warper.h"

namespace cad2slam::cli {

/// A value and the word for it on the command line.
template <class Value>
using Choices = std::vector<std::pair<std::string, Value>>;

/// An option that takes one of a few words. Help and complaints name the words and nothing else, where CLI11's own
/// transformers show the numbers behind them. `target` must outlive the parsing.
template <class Value, class Target>
CLI::Option* addChoice(CLI::App& command, const std::string& name, Target& target, const Choices<Value>& choices,
                       const std::string& description) {
  std::vector<std::string> words;
  for (const auto& [word, value] : choices) words.push_back(word);
  const auto set = [&target, choices](const std::string& given) {
    for (const auto& [word, value] : choices) {
      if (word == given) target = value;
    }
  };
  return command.add_option_function<std::string>(name, set, description)->check(CLI::IsMember(words));
}

inline void addDirection(CLI::App& command, WarpDirection& direction, const std::string& description) {
  const Choices<WarpDirection> choices = {{"slam", WarpDirection::kToSlam}, {"blueprint", WarpDirection::kToBlueprint}};
  addChoice(command, "--to", direction, choices, description)->required();
}

/// Stays empty where the file is to decide.
inline void addOutside(CLI::App& command, std::optional<OutsidePolicy>& outside) {
  const Choices<OutsidePolicy> choices = {{"error", OutsidePolicy::kError}, {"rigid", OutsidePolicy::kRigid}};
  addChoice(command, "--outside", outside, choices, "Beyond the mesh: error or rigid (default: what the file says)");
}

inline void addSemantics(CLI::App& command, MapSemantics& semantics) {
  const Choices<MapSemantics> choices = {{"jazzy", MapSemantics::kJazzy}, {"humble", MapSemantics::kHumble}};
  addChoice(command, "--semantics", semantics, choices, "Read pixels as map_server of jazzy (default) or humble does");
}

}  // namespace cad2slam::cli
