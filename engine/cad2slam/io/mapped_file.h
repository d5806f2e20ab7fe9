// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <string_view>
#include <utility>

#include "cad2slam/core/result.h"

namespace cad2slam {

/// A regular file mapped into memory, read-only, for as long as the object lives. Pages are read when they are touched.
/// A program that shortens the file in place meanwhile breaks its readers, as with any mapped file; one that replaces
/// it (writeFileAtomically, mv, package managers) does not.
class MappedFile {
 public:
  /// kNotFound and kUnreadable as openRegularFile().
  [[nodiscard]] static Result<MappedFile> open(const std::filesystem::path& path);

  MappedFile(MappedFile&& other) noexcept
      : address_(std::exchange(other.address_, nullptr)), size_(std::exchange(other.size_, 0)) {}
  MappedFile& operator=(MappedFile&&) = delete;
  ~MappedFile();

  [[nodiscard]] std::string_view bytes() const { return {static_cast<const char*>(address_), size_}; }
  /// Gives the memory of a part back that will hardly be read again; the bytes stay readable.
  void release(std::string_view part) const;

 private:
  MappedFile(void* address, std::size_t size) : address_(address), size_(size) {}

  void* address_;
  std::size_t size_;
};

}  // namespace cad2slam
