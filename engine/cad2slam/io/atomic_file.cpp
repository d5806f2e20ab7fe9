// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/io/atomic_file.h"

#include "cad2slam/io/file_descriptor.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <optional>
#include <system_error>

namespace cad2slam {
namespace {

namespace fs = std::filesystem;

constexpr int kMaxLinks = 40;                               // as many as Linux follows itself
constexpr std::size_t kBufferBytes = std::size_t{1} << 18;  // small pieces of a producer become few system calls

tl::unexpected<Error> unwritable(const fs::path& path, const std::string& reason) {
  return fail(ErrorCode::kUnwritable, "cannot be written (" + reason + ")", path.string());
}

// The file a chain of symbolic links ends at, which need not exist yet.
Result<fs::path> followLinks(const fs::path& path) {
  fs::path target = path;
  for (int links = 0; links < kMaxLinks; ++links) {
    std::error_code error;
    if (!fs::is_symlink(fs::symlink_status(target, error))) return target;
    const fs::path next = fs::read_symlink(target, error);
    if (error) return unwritable(path, error.message());
    target = next.is_absolute() ? next : target.parent_path() / next;
  }
  return unwritable(path, systemReason(ELOOP));
}

// A file beside the final one that disappears again unless it takes its place.
class TemporaryFile {
 public:
  static Result<TemporaryFile> create(const fs::path& target) {
    static std::atomic<unsigned> serial{0};
    const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
    const auto now = std::chrono::steady_clock::now().time_since_epoch().count();
    int reason = EEXIST;
    for (int attempt = 0; attempt < 100 && reason == EEXIST; ++attempt) {
      // Not the target's name plus something: that could exceed the longest name the file system takes.
      const fs::path name = folder / (".cad2slam-" + std::to_string(::getpid()) + "-" + std::to_string(now) + "-" +
                                      std::to_string(serial.fetch_add(1)) + ".tmp");
      const int descriptor = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
      if (descriptor >= 0) return TemporaryFile(descriptor, name, target);
      reason = errno;
    }
    return unwritable(target, systemReason(reason));
  }

  TemporaryFile(TemporaryFile&& other) noexcept
      : descriptor_(std::exchange(other.descriptor_, -1)),
        name_(std::exchange(other.name_, {})),
        target_(std::move(other.target_)),
        buffer_(std::move(other.buffer_)) {}
  TemporaryFile& operator=(TemporaryFile&&) = delete;
  ~TemporaryFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (!name_.empty()) ::unlink(name_.c_str());
  }

  Result<void> write(std::string_view bytes) {
    if (buffer_.size() + bytes.size() < kBufferBytes) {
      buffer_ += bytes;
      return {};
    }
    if (const Result<void> flushed = writeThrough(buffer_); !flushed) return flushed;
    buffer_.clear();
    return writeThrough(bytes);
  }

  // Owner and permissions of the file that will be replaced; an owner that may not be given away is no failure.
  Result<void> copyPermissions(const struct stat& old_file) {
    if (::fchown(descriptor_, old_file.st_uid, old_file.st_gid) != 0 && errno != EPERM) {
      return unwritable(target_, systemReason(errno));
    }
    if (::fchmod(descriptor_, old_file.st_mode & 07777) != 0) return unwritable(target_, systemReason(errno));
    return {};
  }

  Result<void> replaceTarget() {
    if (const Result<void> flushed = writeThrough(buffer_); !flushed) return flushed;
    buffer_.clear();
    if (::fsync(descriptor_) != 0) return unwritable(target_, systemReason(errno));
    if (::close(std::exchange(descriptor_, -1)) != 0) return unwritable(target_, systemReason(errno));
    if (::rename(name_.c_str(), target_.c_str()) != 0) return unwritable(target_, systemReason(errno));
    name_.clear();
    syncFolder();
    return {};
  }

 private:
  TemporaryFile(int descriptor, fs::path name, fs::path target)
      : descriptor_(descriptor), name_(std::move(name)), target_(std::move(target)) {}

  Result<void> writeThrough(std::string_view bytes) {
    while (!bytes.empty()) {
      const ssize_t count = ::write(descriptor_, bytes.data(), bytes.size());
      if (count >= 0) {
        bytes.remove_prefix(static_cast<std::size_t>(count));
      } else if (errno != EINTR) {
        return unwritable(target_, systemReason(errno));
      }
    }
    return {};
  }

  // Makes the new name survive a power cut. A file system that cannot do it still holds the old or the new file, so a
  // failure here must not claim that nothing was written.
  void syncFolder() const {
    const fs::path folder = target_.has_parent_path() ? target_.parent_path() : fs::path(".");
    const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0) return;
    static_cast<void>(::fsync(descriptor));
    ::close(descriptor);
  }

  int descriptor_;
  fs::path name_;
  fs::path target_;
  std::string buffer_;
};

}  // namespace

Result<void> writeFileAtomically(const fs::path& path, const std::function<Result<void>(const ByteSink&)>& produce) {
  if (!path.has_filename()) return unwritable(path, "a file name is missing");
  const Result<fs::path> target = followLinks(path);
  if (!target) return failAs(target);

  struct stat old_file {};
  const bool replaces = ::stat(target->c_str(), &old_file) == 0;
  if (replaces && S_ISDIR(old_file.st_mode)) return unwritable(path, systemReason(EISDIR));
  if (replaces && !S_ISREG(old_file.st_mode)) return unwritable(path, "it is not a regular file");
  // Renaming over a read-only file would succeed; whoever protected it does not expect that.
  if (replaces && ::access(target->c_str(), W_OK) != 0) return unwritable(path, systemReason(errno));

  Result<TemporaryFile> file = TemporaryFile::create(*target);
  if (!file) return failAs(file);
  if (replaces) {
    if (const Result<void> copied = file->copyPermissions(old_file); !copied) return copied;
  }
  const Result<void> produced = produce([&file](std::string_view bytes) { return file->write(bytes); });
  if (!produced) return produced;
  return file->replaceTarget();
}

Result<void> writeFileAtomically(const fs::path& path, std::string_view content) {
  return writeFileAtomically(path, [content](const ByteSink& sink) { return sink(content); });
}

Result<std::string> readFile(const fs::path& path, std::size_t max_bytes) {
  Result<FileDescriptor> file = openRegularFile(path);
  if (!file) return failAs(file);
  const Result<std::uintmax_t> size = file->size();
  if (!size) return failAs(size);
  const auto tooLarge = [&] {
    return fail(ErrorCode::kMalformed, "is larger than the " + std::to_string(max_bytes) + " bytes that are read",
                path.string());
  };
  if (*size > max_bytes) return tooLarge();
  // The size is only a hint: files of /proc claim 0, and another program may be writing.
  std::string content;
  std::size_t filled = 0;
  content.resize(static_cast<std::size_t>(*size) + 1);
  while (true) {
    const Result<std::size_t> count = file->read(content.data() + filled, content.size() - filled);
    if (!count) return failAs(count);
    if (*count == 0) break;
    filled += *count;
    if (filled > max_bytes) return tooLarge();
    if (filled == content.size()) content.resize(2 * content.size());
  }
  content.resize(filled);
  return content;
}

}  // namespace cad2slam
