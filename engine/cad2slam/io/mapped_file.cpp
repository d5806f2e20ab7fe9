// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/io/mapped_file.h"

#include "cad2slam/io/file_descriptor.h"

#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <limits>

namespace cad2slam {

Result<MappedFile> MappedFile::open(const std::filesystem::path& path) {
  const Result<FileDescriptor> file = openRegularFile(path);
  if (!file) return failAs(file);
  const Result<std::uintmax_t> size = file->size();
  if (!size) return failAs(size);
  if (*size == 0) return MappedFile(nullptr, 0);  // cannot be mapped
  if (*size > std::numeric_limits<std::size_t>::max()) {
    return fail(ErrorCode::kUnreadable, "is too large for this machine", path.string());
  }
  const auto count = static_cast<std::size_t>(*size);
  void* address = ::mmap(nullptr, count, PROT_READ, MAP_PRIVATE, file->get(), 0);
  if (address == MAP_FAILED) {
    return fail(ErrorCode::kUnreadable, "cannot be read (" + systemReason(errno) + ")", path.string());
  }
  static_cast<void>(::madvise(address, count, MADV_WILLNEED));
  return MappedFile(address, count);
}

MappedFile::~MappedFile() {
  if (address_ != nullptr) ::munmap(address_, size_);
}

void MappedFile::release(std::string_view part) const {
  // Whole pages inside the part only.
  const auto page = static_cast<std::uintptr_t>(::sysconf(_SC_PAGESIZE));
  const auto first = (reinterpret_cast<std::uintptr_t>(part.data()) + page - 1) / page * page;
  const auto last = reinterpret_cast<std::uintptr_t>(part.data() + part.size()) / page * page;
  if (first < last) static_cast<void>(::madvise(reinterpret_cast<void*>(first), last - first, MADV_DONTNEED));
}

}  // namespace cad2slam
