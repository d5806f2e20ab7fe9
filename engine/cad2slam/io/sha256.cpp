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

}  // namespace

void Sha256::Free::operator()(evp_md_ctx_st* context) const {
  EVP_MD_CTX_free(context);
}

Sha256::Sha256() : context_(EVP_MD_CTX_new()) {
  require(context_ != nullptr && EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr) == 1);
}

void Sha256::add(const void* bytes, std::size_t count) {
  require(EVP_DigestUpdate(context_.get(), bytes, count));
}

std::string Sha256::finish() {
  Digest digest{};
  require(EVP_DigestFinal_ex(context_.get(), digest.data(), nullptr));
  return hexOf(digest);
}

std::string sha256Hex(const void* bytes, std::size_t count) {
  Sha256 hash;
  hash.add(bytes, count);
  return hash.finish();
}

Result<std::string> sha256HexOfFile(const std::filesystem::path& path) {
  Result<FileDescriptor> file = openRegularFile(path);
  if (!file) return failAs(file);
  Sha256 hash;
  std::vector<char> buffer(std::size_t{1} << 18);
  while (true) {
    const Result<std::size_t> count = file->read(buffer.data(), buffer.size());
    if (!count) return failAs(count);
    if (*count == 0) return hash.finish();
    hash.add(buffer.data(), *count);
  }
}

}  // namespace cad2slam
