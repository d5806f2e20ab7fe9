// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "app/cli_command.h"
#include "cad2slam/io/projector_file.h"

namespace cad2slam::cli {
namespace {

enum class Target { kSlam, kBlueprint };

struct ProjectOptions {
  std::string projector;
  std::string input = "-";
  Target target = Target::kSlam;
  std::string outside;
};

constexpr std::size_t kLongestLine = 4096;

bool isSeparator(char c) {
  return c == ',' || c == ';' || c == '\t' || c == ' ' || c == '\r';
}

/// Reads `x y [theta]`, separated by commas, semicolons, tabs or spaces; nullopt when the line says anything else.
std::optional<Pose2> parsePose(std::string_view line) {
  std::array<double, 3> values{};
  std::size_t count = 0;
  const char* at = line.data();
  const char* const end = line.data() + line.size();
  while (true) {
    while (at != end && isSeparator(*at)) ++at;
    if (at == end) break;
    if (count == values.size()) return std::nullopt;
    if (*at == '+') ++at;
    const auto [next, error] = std::from_chars(at, end, values[count]);
    if (error != std::errc{} || (next != end && !isSeparator(*next)) || !std::isfinite(values[count]))
      return std::nullopt;
    at = next;
    ++count;
  }
  if (count < 2) return std::nullopt;
  return Pose2{{values[0], values[1]}, values[2]};
}

std::string_view statusName(ProjectionStatus status) {
  switch (status) {
    case ProjectionStatus::kInside:
      return "inside";
    case ProjectionStatus::kExtrapolated:
      return "extrapolated";
    case ProjectionStatus::kOutside:
      return "outside";
    case ProjectionStatus::kFolded:
      return "folded";
    case ProjectionStatus::kInvalid:
      break;
  }
  return "invalid";
}

bool isBlankOrComment(std::string_view line) {
  const std::size_t first = line.find_first_not_of(" \t\r");
  return first == std::string_view::npos || line[first] == '#';
}

bool isHeader(std::string_view line) {
  const std::size_t first = line.find_first_not_of(" \t\r\"");
  return first != std::string_view::npos && (line[first] == 'x' || line[first] == 'X');
}

/// Projects one stream line by line: memory does not grow with its length.
class LineProjector {
 public:
  LineProjector(const Projector& projector, const ProjectOptions& options) : projector_(projector), options_(options) {
    outside_ = options.outside.empty()      ? projector.info().outside
               : options.outside == "rigid" ? OutsidePolicy::kRigid
                                            : OutsidePolicy::kError;
  }

  Result<void> run(std::istream& in, const std::string& name) {
    std::string line;
    line.reserve(kLongestLine);
    while (readLine(in, line)) {
      ++line_number_;
      if (line.size() > kLongestLine) {
        flush();
        return fail(ErrorCode::kMalformed, "the line is too long", place(name));
      }
      if (isBlankOrComment(line)) {
        append(line + "\n");
      } else if (line_number_ == 1 && isHeader(line)) {
        append("x,y,theta,status\n");
      } else if (const std::optional<Pose2> pose = parsePose(line)) {
        answer(*pose);
      } else {
        flush();
        return fail(ErrorCode::kMalformed, "expected x,y or x,y,theta in metres and radians", place(name));
      }
      if (buffer_.size() > kBufferSize && !flush()) break;
    }
    if (!flush() || !std::cout) return fail(ErrorCode::kUnwritable, "the output could not be written");
    if (in.bad()) return fail(ErrorCode::kUnreadable, "the input could not be read", place(name));
    if (unanswered_ == 0) return {};
    return fail(ErrorCode::kOutOfDomain,
                fmt::format("{} of {} poses have no answer because they lie outside the mesh or where it folds (the "
                            "first in line {})",
                            unanswered_, poses_, first_unanswered_),
                name);
  }

 private:
  static constexpr std::size_t kBufferSize = 1 << 16;

  /// getline() that stops one character after the longest line, so that a file without line ends is not swallowed.
  static bool readLine(std::istream& in, std::string& line) {
    line.clear();
    std::streambuf* source = in.rdbuf();
    for (int c = source->sbumpc(); c != std::char_traits<char>::eof(); c = source->sbumpc()) {
      if (c == '\n') return true;
      line.push_back(static_cast<char>(c));
      if (line.size() > kLongestLine) return true;
    }
    return !line.empty();
  }

  void answer(const Pose2& pose) {
    const Projection projected = options_.target == Target::kSlam ? projector_.slamFromBlueprint(pose, outside_)
                                                                  : projector_.blueprintFromSlam(pose, outside_);
    ++poses_;
    if (projected.ok()) {
      fmt::format_to(std::back_inserter(buffer_), "{:.9f},{:.9f},{:.9f},{}\n", projected.pose.translation.x(),
                     projected.pose.translation.y(), projected.pose.heading, statusName(projected.status));
      return;
    }
    if (unanswered_++ == 0) first_unanswered_ = line_number_;
    append(fmt::format("nan,nan,nan,{}\n", statusName(projected.status)));
  }

  void append(std::string_view text) { buffer_.append(text.data(), text.data() + text.size()); }

  bool flush() {
    std::cout.write(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
    buffer_.clear();
    return static_cast<bool>(std::cout);
  }

  [[nodiscard]] std::string place(const std::string& name) const { return name + ":" + std::to_string(line_number_); }

  const Projector& projector_;
  const ProjectOptions& options_;
  OutsidePolicy outside_ = OutsidePolicy::kError;
  fmt::memory_buffer buffer_;
  std::size_t line_number_ = 0;
  std::size_t poses_ = 0;
  std::size_t unanswered_ = 0;
  std::size_t first_unanswered_ = 0;
};

Result<void> projectStream(const ProjectOptions& options) {
  const Result<Projector> projector = loadProjector(options.projector);
  if (!projector) return failAs(projector);
  LineProjector lines(*projector, options);
  std::ios::sync_with_stdio(false);
  if (options.input == "-") return lines.run(std::cin, "standard input");
  std::error_code unknown;
  if (std::filesystem::is_directory(options.input, unknown)) {
    return fail(ErrorCode::kUnreadable, "is a folder, not a file of poses", options.input);
  }
  std::ifstream file(options.input, std::ios::binary);
  if (!file) return fail(ErrorCode::kNotFound, "the file cannot be opened", options.input);
  return lines.run(file, options.input);
}

}  // namespace

void addProjectCommand(CLI::App& app, ActionSlot& chosen) {
  auto options = std::make_shared<ProjectOptions>();
  CLI::App* command = app.add_subcommand("project", "Project poses, one a line: x,y[,theta] in, x,y,theta,status out");
  command->add_option("projector", options->projector, "Projector file (.c2s)")->required();
  command->add_option("input", options->input, "File of poses, or - for standard input")->capture_default_str();
  command->add_option("--to", options->target, "Frame of the answers: slam or blueprint")
      ->required()
      ->transform(CLI::CheckedTransformer(
          std::map<std::string, Target>{{"slam", Target::kSlam}, {"blueprint", Target::kBlueprint}}));
  command->add_option("--outside", options->outside, "Beyond the mesh: error or rigid (default: what the file says)")
      ->check(CLI::IsMember({"error", "rigid"}));
  command->callback([options, &chosen] { chosen.set([options] { return projectStream(*options); }); });
}

}  // namespace cad2slam::cli
