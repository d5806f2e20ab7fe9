// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "cad2slam/core/result.h"

namespace cad2slam {

/// Parses a whole text as JSON that may come from anybody: kMalformed, with the line, for text that is no JSON, nesting
/// deeper than 64 (the library recurses when it copies and writes a document) and keys that stand twice in one object.
[[nodiscard]] Result<nlohmann::json> parseStrictJson(std::string_view text, const std::string& file_name);

}  // namespace cad2slam
