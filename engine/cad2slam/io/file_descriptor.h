// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>

#include "cad2slam/core/result.h"

namespace cad2slam {

/// An open file of the system that is closed with the object.
class FileDescriptor {
 public:
  FileDescriptor(int descriptor, std::filesystem::path path) : descriptor_(descriptor), path_(std::move(path)) {}
  FileDescriptor(FileDescriptor&& other) noexcept
      : descriptor_(std::exchange(other.descriptor_, -1)), path_(std::move(other.path_)) {}
  FileDescriptor& operator=(FileDescriptor&& other) noexcept {
    std::swap(descriptor_, other.descriptor_);
    std::swap(path_, other.path_);
    return *this;
  }
  ~FileDescriptor();

  [[nodiscard]] int get() const { return descriptor_; }
  /// kUnreadable with the system's reason.
  [[nodiscard]] Result<std::uintmax_t> size() const;
  /// Up to `capacity` bytes; 0 only at the end of the file. kUnreadable with the system's reason.
  [[nodiscard]] Result<std::size_t> read(char* bytes, std::size_t capacity);
  /// `count` bytes from `offset` on, fewer only where the file ends. Leaves the place of read() alone.
  [[nodiscard]] Result<std::string> readAt(std::uintmax_t offset, std::size_t count) const;

 private:
  int descriptor_;
  std::filesystem::path path_;
};

/// Opens for reading. kNotFound; kUnreadable for anything that is not a regular file (a pipe would block, a device may
/// never end) and for what the system refuses.
[[nodiscard]] Result<FileDescriptor> openRegularFile(const std::filesystem::path& path);

/// The system's words for an errno.
[[nodiscard]] std::string systemReason(int error_number);

}  // namespace cad2slam
