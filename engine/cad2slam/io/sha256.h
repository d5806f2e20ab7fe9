// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>

#include "cad2slam/core/result.h"

namespace cad2slam {

/// SHA-256 as 64 lower-case hex digits.
[[nodiscard]] std::string sha256Hex(const void* bytes, std::size_t count);
[[nodiscard]] Result<std::string> sha256HexOfFile(const std::filesystem::path& path);

}  // namespace cad2slam
