// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "cad2slam/core/result.h"
#include "cad2slam/io/file_descriptor.h"

namespace cad2slam {

/// Bytes of a file or of the caller's memory, read once from front to end into memory of the reader.
///
/// A file is not mapped: another program could change what has been checked, and end this process (SIGBUS) by cutting
/// the file.
class ByteSource {
 public:
  /// `bytes` must stay where they are; `name` is what errors call them.
  [[nodiscard]] static ByteSource ofMemory(std::string_view bytes, std::string name);
  /// The errors of openRegularFile().
  [[nodiscard]] static Result<ByteSource> ofFile(const std::filesystem::path& path);

  [[nodiscard]] const std::string& name() const { return name_; }
  /// [bytes] Not yet read, of those that were there at the beginning.
  [[nodiscard]] std::uintmax_t remaining() const { return remaining_; }
  /// Exactly `count` bytes, at most remaining(). kMalformed where the file has been cut meanwhile, kUnreadable with the
  /// system's reason.
  [[nodiscard]] Result<void> read(char* bytes, std::size_t count);

 private:
  ByteSource() = default;

  std::string name_;
  std::uintmax_t remaining_ = 0;
  std::string_view memory_;  // what is left of it
  std::optional<FileDescriptor> file_;
};

}  // namespace cad2slam
