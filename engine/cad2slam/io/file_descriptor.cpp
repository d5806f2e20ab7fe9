// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/io/file_descriptor.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace cad2slam {

std::string systemReason(int error_number) {
  return std::generic_category().message(error_number);
}

FileDescriptor::~FileDescriptor() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

Result<std::uintmax_t> FileDescriptor::size() const {
  struct stat status {};
  if (::fstat(descriptor_, &status) != 0) {
    return fail(ErrorCode::kUnreadable, "cannot be read (" + systemReason(errno) + ")", path_.string());
  }
  return static_cast<std::uintmax_t>(status.st_size);
}

Result<std::size_t> FileDescriptor::read(char* bytes, std::size_t capacity) {
  while (true) {
    const ssize_t count = ::read(descriptor_, bytes, capacity);
    if (count >= 0) return static_cast<std::size_t>(count);
    if (errno != EINTR) {
      return fail(ErrorCode::kUnreadable, "cannot be read (" + systemReason(errno) + ")", path_.string());
    }
  }
}

Result<std::string> FileDescriptor::readAt(std::uintmax_t offset, std::size_t count) const {
  std::string bytes(count, '\0');
  std::size_t filled = 0;
  while (filled < count) {
    const ssize_t got =
        ::pread(descriptor_, bytes.data() + filled, count - filled, static_cast<off_t>(offset + filled));
    if (got == 0) break;
    if (got > 0) {
      filled += static_cast<std::size_t>(got);
    } else if (errno != EINTR) {
      return fail(ErrorCode::kUnreadable, "cannot be read (" + systemReason(errno) + ")", path_.string());
    }
  }
  bytes.resize(filled);
  return bytes;
}

Result<FileDescriptor> openRegularFile(const std::filesystem::path& path) {
  const std::string where = path.string();
  // O_NONBLOCK: opening a pipe that nobody writes to would wait for ever.
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
  if (descriptor < 0) {
    const int reason = errno;
    if (reason == ENOENT || reason == ENOTDIR) return fail(ErrorCode::kNotFound, "there is no such file", where);
    return fail(ErrorCode::kUnreadable, "cannot be opened (" + systemReason(reason) + ")", where);
  }
  FileDescriptor file(descriptor, path);
  struct stat status {};
  if (::fstat(descriptor, &status) != 0) {
    return fail(ErrorCode::kUnreadable, "cannot be read (" + systemReason(errno) + ")", where);
  }
  if (S_ISDIR(status.st_mode)) return fail(ErrorCode::kUnreadable, "is a folder, not a file", where);
  if (!S_ISREG(status.st_mode)) return fail(ErrorCode::kUnreadable, "is not a regular file", where);
  return file;
}

}  // namespace cad2slam
