// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "cad2slam/core/result.h"
#include "cad2slam/planning/start_goal.h"

namespace cad2slam {

/// CSV `start_x,start_y,goal_x,goal_y`, metres, with or without that header; `#` comments and blank lines are skipped.
/// kMalformed names the first line that is not four numbers; also when there is no line at all.
[[nodiscard]] Result<std::vector<StartGoal>> parsePathsCsv(std::string_view text, const std::string& file_name);
[[nodiscard]] Result<std::vector<StartGoal>> readPathsCsv(const std::filesystem::path& path);

}  // namespace cad2slam
