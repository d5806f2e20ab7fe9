// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/io/byte_source.h"

#include <utility>

namespace cad2slam {

ByteSource ByteSource::ofMemory(std::string_view bytes, std::string name) {
  ByteSource source;
  source.name_ = std::move(name);
  source.remaining_ = bytes.size();
  source.memory_ = bytes;
  return source;
}

Result<ByteSource> ByteSource::ofFile(const std::filesystem::path& path) {
  Result<FileDescriptor> file = openRegularFile(path);
  if (!file) return failAs(file);
  const Result<std::uintmax_t> size = file->size();
  if (!size) return failAs(size);
  ByteSource source;
  source.name_ = path.string();
  source.remaining_ = *size;
  source.file_ = std::move(*file);
  return source;
}

Result<void> ByteSource::read(char* bytes, std::size_t count) {
  if (count > remaining_) return fail(ErrorCode::kMalformed, "ends too early", name_);
  remaining_ -= count;
  if (!file_) {
    memory_.copy(bytes, count);
    memory_.remove_prefix(count);
    return {};
  }
  while (count > 0) {
    const Result<std::size_t> got = file_->read(bytes, count);
    if (!got) return failAs(got);
    if (*got == 0) return fail(ErrorCode::kMalformed, "was cut off while it was read", name_);
    bytes += *got;
    count -= *got;
  }
  return {};
}

}  // namespace cad2slam
