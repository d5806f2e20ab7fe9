// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/io/paths_csv.h"

#include "cad2slam/io/atomic_file.h"
#include "cad2slam/io/delimited_text.h"
#include "cad2slam/io/text.h"

#include <array>
#include <optional>

namespace cad2slam {
namespace {

constexpr std::size_t kMaxBytes = 64U << 20;

}  // namespace

Result<std::vector<StartGoal>> parsePathsCsv(std::string_view text, const std::string& file_name) {
  RecordReader reader(withoutByteOrderMark(text), ',');
  std::vector<StartGoal> paths;
  bool is_first = true;
  while (const std::optional<TextRecord> record = reader.next()) {
    const bool may_be_header = is_first;
    is_first = false;
    std::array<double, 4> numbers{};
    bool complete = record->complaint.empty() && record->fields.size() == numbers.size();
    for (std::size_t i = 0; complete && i < numbers.size(); ++i) {
      const std::optional<double> number = parseNumber(record->fields[i]);
      complete = number.has_value();
      numbers[i] = number.value_or(0.0);
    }
    if (complete) {
      paths.push_back({{numbers[0], numbers[1]}, {numbers[2], numbers[3]}});
    } else if (!may_be_header || record->fields.empty() || record->fields.front() != "start_x") {
      return fail(ErrorCode::kMalformed, "a path needs four numbers: start_x, start_y, goal_x, goal_y",
                  file_name + ":" + std::to_string(record->line));
    }
  }
  if (paths.empty()) return fail(ErrorCode::kMalformed, "the file holds no path", file_name);
  return paths;
}

Result<std::vector<StartGoal>> readPathsCsv(const std::filesystem::path& path) {
  const Result<std::string> text = readFile(path, kMaxBytes);
  if (!text) return failAs(text);
  return parsePathsCsv(*text, path.string());
}

}  // namespace cad2slam
