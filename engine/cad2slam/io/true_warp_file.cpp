// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/io/true_warp_file.h"

#include "cad2slam/io/atomic_file.h"
#include "cad2slam/io/guarded_yaml.h"

#include <bit>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <sstream>
#include <string_view>

namespace cad2slam {
namespace {

static_assert(std::endian::native == std::endian::little, "the grid file is written and read as it lies in memory");
static_assert(sizeof(TrueWarp::Sample) == 3 * sizeof(float));

constexpr std::string_view kMagic = "\x93NUMPY\x01";
constexpr std::size_t kPreambleBytes = 10;  // magic, version 1.0, length of the header as u16
constexpr std::size_t kMaxYamlBytes = 1 << 16;
constexpr std::size_t kMaxGridBytes = std::size_t{1} << 31;

struct Shape {
  int rows = 0;
  int columns = 0;
};

/// The next whole number of a text, which is shortened to what follows it.
bool takeInteger(std::string_view& text, int& value) {
  const std::size_t at = text.find_first_of("0123456789");
  if (at == std::string_view::npos) return false;
  text.remove_prefix(at);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return error == std::errc();
}

Result<Shape> parseShape(std::string_view header, const std::string& file_name) {
  if (header.find("'<f4'") == std::string_view::npos || header.find("False") == std::string_view::npos) {
    return fail(ErrorCode::kMalformed, "The grid must hold little-endian float32 in C order", file_name);
  }
  const std::size_t at = header.find("'shape'");
  if (at != std::string_view::npos) {
    std::string_view rest = header.substr(at);
    Shape shape;
    int depth = 0;
    if (takeInteger(rest, shape.rows) && takeInteger(rest, shape.columns) && takeInteger(rest, depth) && depth == 3) {
      return shape;
    }
  }
  return fail(ErrorCode::kMalformed, "The grid must have the shape rows x columns x 3", file_name);
}

Result<TrueWarp::Layout> parseLayout(const YAML::Node& document, const std::string& file_name) {
  TrueWarp::Layout layout;
  try {
    const YAML::Node origin = document["origin"];
    if (!origin || !origin.IsSequence() || origin.size() != 2) {
      return fail(ErrorCode::kMalformed, "`origin` must be two numbers", file_name);
    }
    layout.first = {origin[0].as<double>(), origin[1].as<double>()};
    layout.step_m = document["step"].as<double>();
  } catch (const YAML::Exception&) {
    return fail(ErrorCode::kMalformed, "`origin` and `step` must be numbers", file_name);
  }
  return layout;
}

Result<std::string> parseGridName(const YAML::Node& document, const std::string& file_name) {
  try {
    if (document.IsMap() && document["grid"]) return document["grid"].as<std::string>();
  } catch (const YAML::Exception&) {  // answered below
  }
  return fail(ErrorCode::kMalformed, "`grid` must name a file", file_name);
}

}  // namespace

Result<TrueWarp> readTrueWarp(const std::filesystem::path& yaml) {
  const std::string file_name = yaml.string();
  const Result<std::string> text = readFile(yaml, kMaxYamlBytes);
  if (!text) return failAs(text);
  const Result<YAML::Node> document = loadYaml(*text, file_name);
  if (!document) return failAs(document);
  const Result<std::string> grid_name = parseGridName(*document, file_name);
  if (!grid_name) return failAs(grid_name);
  Result<TrueWarp::Layout> layout = parseLayout(*document, file_name);
  if (!layout) return failAs(layout);

  const std::filesystem::path grid_path = yaml.parent_path() / *grid_name;
  const Result<std::string> bytes = readFile(grid_path, kMaxGridBytes);
  if (!bytes) return failAs(bytes);
  const std::string_view content = *bytes;
  if (content.size() < kPreambleBytes || content.substr(0, kMagic.size()) != kMagic) {
    return fail(ErrorCode::kMalformed, "This is not a NumPy file of version 1", grid_path.string());
  }
  const std::size_t header_bytes = static_cast<std::size_t>(static_cast<std::uint8_t>(content[8])) |
                                   static_cast<std::size_t>(static_cast<std::uint8_t>(content[9])) << 8;
  if (content.size() < kPreambleBytes + header_bytes) {
    return fail(ErrorCode::kMalformed, "The file ends inside its header", grid_path.string());
  }
  const Result<Shape> shape = parseShape(content.substr(kPreambleBytes, header_bytes), grid_path.string());
  if (!shape) return failAs(shape);
  const std::string_view data = content.substr(kPreambleBytes + header_bytes);
  const std::size_t count = static_cast<std::size_t>(shape->rows) * static_cast<std::size_t>(shape->columns);
  if (data.size() % sizeof(TrueWarp::Sample) != 0 || data.size() / sizeof(TrueWarp::Sample) != count) {
    return fail(ErrorCode::kMalformed, "The file is not as long as its shape says", grid_path.string());
  }
  std::vector<TrueWarp::Sample> samples(count);
  if (count > 0) std::memcpy(samples.data(), data.data(), data.size());
  layout->rows = shape->rows;
  layout->columns = shape->columns;
  Result<TrueWarp> warp = TrueWarp::create(*layout, std::move(samples));
  if (!warp) return fail(warp.error().code, warp.error().message, grid_path.string());
  return warp;
}

Result<void> writeTrueWarp(const std::filesystem::path& yaml, const TrueWarp& warp) {
  const TrueWarp::Layout& layout = warp.layout();
  std::string header = "{'descr': '<f4', 'fortran_order': False, 'shape': (" + std::to_string(layout.rows) + ", " +
                       std::to_string(layout.columns) + ", 3), }";
  constexpr std::size_t kAlignment = 64;
  header.append(kAlignment - 1 - (kPreambleBytes + header.size()) % kAlignment, ' ');
  header.push_back('\n');
  std::string bytes(kMagic);
  bytes.push_back('\0');
  bytes.push_back(static_cast<char>(header.size() & 0xff));
  bytes.push_back(static_cast<char>(header.size() >> 8));
  bytes += header;
  bytes.append(reinterpret_cast<const char*>(warp.samples().data()), warp.samples().size() * sizeof(TrueWarp::Sample));
  const std::filesystem::path grid_path = std::filesystem::path(yaml).replace_extension(".npy");
  if (Result<void> written = writeFileAtomically(grid_path, bytes); !written) return written;

  std::ostringstream text;
  text.precision(17);
  text << "# True SLAM pose (x, y, heading) of the blueprint pose with heading 0 at origin + step * [column, row];\n"
          "# metres and radians, rows grow with y, NaN where there is no building. Read bilinearly.\n"
       << "grid: " << grid_path.filename().string() << "\n"
       << "origin: [" << layout.first.x() << ", " << layout.first.y() << "]\n"
       << "step: " << layout.step_m << "\n";
  return writeFileAtomically(yaml, text.str());
}

}  // namespace cad2slam
