// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "cad2slam/io/projector_header.h"

namespace cad2slam::test {

struct ProjectorParts {
  ProjectorHeader header;
  std::string data;
};

/// The parts of a projector file, which may then be changed.
inline Result<ProjectorParts> partsOf(std::string_view bytes) {
  ByteSource source = ByteSource::ofMemory(bytes, "a.c2s");
  const Result<ProjectorHeader> header = readProjectorHeader(source);
  if (!header) return failAs(header);
  std::string data(static_cast<std::size_t>(source.remaining()), '\0');
  if (const Result<void> read = source.read(data.data(), data.size()); !read) return failAs(read);
  return ProjectorParts{*header, data};
}

}  // namespace cad2slam::test
