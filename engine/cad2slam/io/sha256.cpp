// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/io/sha256.h"

#include "cad2slam/io/file_descriptor.h"

#include <openssl/evp.h>

#include <array>
#include <new>
#include <vector>

namespace cad2slam {
namespace {

using Digest = std::array<unsigned char, 32>;

std::string hexOf(const Digest& digest) {
  constexpr char kDigits[] = "0123456789abcdef";
  std::string hex;
  hex.reserve(2 * digest.size());
  for (const unsigned char byte : digest) {
    hex += kDigits[byte >> 4];
    hex += kDigits[byte & 15];
  }
  return hex;
}

// SHA-256 itself cannot fail; what OpenSSL reports is that memory ran out.
void require(int openssl_result) {
  if (openssl_result != 1) throw std::bad_alloc();
}

class Hasher {
 public:
  Hasher() : context_(EVP_MD_CTX_new()) {
    require(context_ != nullptr && EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr) == 1);
  }
  void add(const void* bytes, std::size_t count) { require(EVP_DigestUpdate(context_.get(), bytes, count)); }
  [[nodiscard]] std::string finish() {
    Digest digest{};
    require(EVP_DigestFinal_ex(context_.get(), digest.data(), nullptr));
    return hexOf(digest);
  }

 private:
  struct Free {
    void operator()(EVP_MD_CTX* context) const { EVP_MD_CTX_free(context); }
  };
  std::unique_ptr<EVP_MD_CTX, Free> context_;
};

}  // namespace

std::string sha256Hex(const void* bytes, std::size_t count) {
  Hasher hasher;
  hasher.add(bytes, count);
  return hasher.finish();
}

Result<std::string> sha256HexOfFile(const std::filesystem::path& path) {
  Result<FileDescriptor> file = openRegularFile(path);
  if (!file) return failAs(file);
  Hasher hasher;
  std::vector<char> buffer(std::size_t{1} << 18);
  while (true) {
    const Result<std::size_t> count = file->read(buffer.data(), buffer.size());
    if (!count) return failAs(count);
    if (*count == 0) return hasher.finish();
    hasher.add(buffer.data(), *count);
  }
}

}  // namespace cad2slam
