// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "cad2slam/core/result.h"

namespace cad2slam {

/// Replaces `path` by `content` so that at every moment either the old or the new file is complete: temporary file in
/// the same folder, fsync, rename, fsync of the folder. kUnwritable with the system's reason; then nothing changed and
/// no temporary file is left. Keeps the permissions of a file it replaces; follows a symbolic link to its target.
[[nodiscard]] Result<void> writeFileAtomically(const std::filesystem::path& path, std::string_view content);

/// The same for content that is produced piece by piece: `produce` is called once with a sink and may call it often.
using ByteSink = std::function<Result<void>(std::string_view)>;
[[nodiscard]] Result<void> writeFileAtomically(const std::filesystem::path& path,
                                               const std::function<Result<void>(const ByteSink&)>& produce);

/// The whole file. kNotFound, kUnreadable (a folder, no permission, a device), kMalformed when larger than `max_bytes`.
[[nodiscard]] Result<std::string> readFile(const std::filesystem::path& path, std::size_t max_bytes);

}  // namespace cad2slam
