// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "app/cli_command.h"
#include "app/cli_options.h"
#include "cad2slam/exports/robot_to_robot.h"
#include "cad2slam/io/pose_protocol.h"
#include "cad2slam/io/projector_file.h"

namespace cad2slam::cli {
namespace {

/// What nine decimals would show as -0.000000000 is zero.
double withoutMinusZero(double value) {
  constexpr double kHalfOfLastDigit = 0.5e-9;
  return std::abs(value) < kHalfOfLastDigit ? 0.0 : value;
}

struct ProjectOptions {
  std::vector<std::string> files;  ///< projector and input; only the input with `from`
  std::string from;
  std::string to;
  std::optional<OutsidePolicy> outside;
};

using PoseFunction = std::function<Projection(const Pose2&)>;

constexpr std::size_t kLongestLine = 4096;

bool isSeparator(char c) {
  return c == ',' || c == ';' || c == '\t' || c == ' ' || c == '\r';
}

/// A column of letters, as the status that `project` itself writes.
bool isWord(std::string_view text) {
  return std::all_of(text.begin(), text.end(), [](char c) { return (c >= 'a' && c <= 'z') || c == '-'; });
}

/// Reads `x y [theta [status]]`, separated by commas, semicolons, tabs or spaces; nullopt when the line says anything
/// else. The status is accepted, so that the output of one run is input of the next; only with one may values be nan.
std::optional<Pose2> parsePose(std::string_view line) {
  std::array<double, 3> values{};
  std::size_t count = 0;
  bool has_status = false;
  const char* at = line.data();
  const char* const end = line.data() + line.size();
  while (true) {
    while (at != end && isSeparator(*at)) ++at;
    if (at == end) break;
    if (count == values.size()) {
      const char* const last = std::find_if(at, end, isSeparator);
      if (!isWord({at, static_cast<std::size_t>(last - at)}) || !std::all_of(last, end, isSeparator))
        return std::nullopt;
      has_status = true;
      break;
    }
    if (*at == '+') ++at;
    const auto [next, error] = std::from_chars(at, end, values[count]);
    if (error != std::errc{} || (next != end && !isSeparator(*next))) return std::nullopt;
    at = next;
    ++count;
  }
  const bool finite = std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
  if (count < 2 || (!finite && !has_status)) return std::nullopt;
  return Pose2{{values[0], values[1]}, values[2]};
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
  explicit LineProjector(PoseFunction project) : project_(std::move(project)) {}

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
    const Projection projected = project_(pose);
    ++poses_;
    if (projected.ok()) {
      fmt::format_to(std::back_inserter(buffer_), "{:.9f},{:.9f},{:.9f},{}\n",
                     withoutMinusZero(projected.pose.translation.x()), withoutMinusZero(projected.pose.translation.y()),
                     withoutMinusZero(projected.pose.heading), nameOf(projected.status));
      return;
    }
    if (unanswered_++ == 0) first_unanswered_ = line_number_;
    append(fmt::format("nan,nan,nan,{}\n", nameOf(projected.status)));
  }

  void append(std::string_view text) { buffer_.append(text.data(), text.data() + text.size()); }

  bool flush() {
    std::cout.write(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
    buffer_.clear();
    return static_cast<bool>(std::cout);
  }

  [[nodiscard]] std::string place(const std::string& name) const { return name + ":" + std::to_string(line_number_); }

  PoseFunction project_;
  fmt::memory_buffer buffer_;
  std::size_t line_number_ = 0;
  std::size_t poses_ = 0;
  std::size_t unanswered_ = 0;
  std::size_t first_unanswered_ = 0;
};

Result<PoseFunction> functionOfOne(const ProjectOptions& options) {
  Result<Projector> loaded = loadProjector(options.files.front());
  if (!loaded) return failAs(loaded);
  const OutsidePolicy outside = options.outside.value_or(loaded->info().outside);
  const bool to_slam = options.to == "slam";
  return [projector = std::move(*loaded), outside, to_slam](const Pose2& pose) {
    return to_slam ? projector.slamFromBlueprint(pose, outside) : projector.blueprintFromSlam(pose, outside);
  };
}

Result<PoseFunction> functionOfTwo(const ProjectOptions& options) {
  const Result<Projector> from = loadProjector(options.from);
  if (!from) return failAs(from);
  const Result<Projector> to = loadProjector(options.to);
  if (!to) return failAs(to);
  const Result<RobotToRobot> both = RobotToRobot::create(*from, *to);
  if (!both) return fail(both.error().code, both.error().message, options.from + " and " + options.to);
  if (!options.outside) return [chain = *both](const Pose2& pose) { return chain.project(pose); };
  return [chain = *both, outside = *options.outside](const Pose2& pose) { return chain.project(pose, outside); };
}

Result<void> projectStream(const ProjectOptions& options) {
  const bool two = !options.from.empty();
  const Result<PoseFunction> function = two ? functionOfTwo(options) : functionOfOne(options);
  if (!function) return failAs(function);
  const std::size_t before_input = two ? 0 : 1;
  const std::string input = options.files.size() > before_input ? options.files.back() : "-";
  LineProjector lines(*function);
  std::ios::sync_with_stdio(false);
  if (input == "-") return lines.run(std::cin, "standard input");
  std::error_code unknown;
  if (std::filesystem::is_directory(input, unknown)) {
    return fail(ErrorCode::kUnreadable, "is a folder, not a file of poses", input);
  }
  std::ifstream file(input, std::ios::binary);
  if (!file) return fail(ErrorCode::kNotFound, "the file cannot be opened", input);
  return lines.run(file, input);
}

/// One projector and a frame, or two projectors. What does not fit is wrong usage, not a failure.
void checkFiles(const ProjectOptions& options) {
  if (options.from.empty()) {
    if (options.files.empty()) throw CLI::RequiredError("projector");
    if (options.to != "slam" && options.to != "blueprint") {
      throw CLI::ValidationError("--to", "must be slam or blueprint, or a projector file together with --from");
    }
  } else if (options.files.size() > 1) {
    throw CLI::ExtrasError({options.files.front()});
  } else if (options.to == "slam" || options.to == "blueprint") {
    throw CLI::ValidationError("--to", "must be a projector file together with --from");
  }
}

}  // namespace

void addProjectCommand(CLI::App& app, ActionSlot& chosen) {
  auto options = std::make_shared<ProjectOptions>();
  CLI::App* command = app.add_subcommand(
      "project", "Project poses, one a line: x,y[,theta] in, x,y,theta,status out; metres and radians");
  command->add_option("files", options->files, "Projector file (.c2s), then a file of poses or - for standard input")
      ->expected(0, 2)
      ->type_name("[PROJECTOR] [INPUT]");
  command->add_option("--to", options->to, "Frame of the answers: slam or blueprint; with --from a projector file")
      ->required();
  command->add_option("--from", options->from,
                      "Projector of the robot whose poses are read; they go through the blueprint to that of --to");
  addOutside(*command, options->outside);
  command->callback([options, &chosen] {
    checkFiles(*options);
    chosen.set([options] { return projectStream(*options); });
  });
}

}  // namespace cad2slam::cli
