// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>

#include "cad2slam/io/project_file.h"
#include "fuzz/property.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace cad2slam;
  const std::filesystem::path path = "/projects/building.c2sproj";
  const auto read = parseProject(std::string(reinterpret_cast<const char*>(data), size), path);
  if (!read) return 0;
  const std::string written = formatProject(*read, path);
  const auto again = parseProject(written, path);
  fuzzing::expect(again.has_value(), "what was written can be read");
  fuzzing::expect(formatProject(*again, path) == written, "writing what was read changes nothing");
  return 0;
}
