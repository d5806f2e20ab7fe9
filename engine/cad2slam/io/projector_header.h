// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "cad2slam/core/result.h"
#include "cad2slam/io/byte_source.h"

namespace cad2slam {

/// One array of a projector file as its header describes it.
struct ArrayEntry {
  std::string dtype;  ///< "F64", "I32", ...
  std::vector<std::uint64_t> shape;
  std::uint64_t begin = 0;  ///< [bytes] in the data section
  std::uint64_t end = 0;
};

/// The JSON header of a safetensors file, by name. std::map: the same content has one text.
struct ProjectorHeader {
  std::map<std::string, ArrayEntry> arrays;
  std::map<std::string, std::string> metadata;
};

inline constexpr std::size_t kLargestProjectorHeader = std::size_t{1} << 20;

/// Reads a file up to its data section and checks all that holds for any safetensors file, and no more than that: the
/// length of the header, its flat shape, no name twice, known types, shape times type fits the range, and the ranges
/// cover the rest of the file exactly, without overlap or gap. kMalformed names what is wrong.
[[nodiscard]] Result<ProjectorHeader> readProjectorHeader(ByteSource& source);

/// Compact JSON with sorted keys: what json.dumps(header, sort_keys=True, separators=(",", ":"), ensure_ascii=False)
/// gives in Python. Bytes that are no UTF-8 become U+FFFD.
[[nodiscard]] std::string formatProjectorHeader(const ProjectorHeader& header);

/// Adds the metadata `data_sha256` (of the data section) and `header_sha256` (of formatProjectorHeader() without that
/// key itself).
void sealProjectorHeader(ProjectorHeader& header, std::string_view data);
/// Whether the seal of the header itself holds; that of the data is the caller's to check, who may want to do it while
/// the data are already in use.
[[nodiscard]] bool headerSealHolds(const ProjectorHeader& header);
inline constexpr const char* kDataSealKey = "data_sha256";

/// Everything before the data section: length, JSON and the blanks that make the data start on a multiple of 64.
[[nodiscard]] std::string formatProjectorPrefix(const ProjectorHeader& header);

}  // namespace cad2slam
