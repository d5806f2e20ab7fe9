// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>

#include "cad2slam/core/result.h"

struct evp_md_ctx_st;  // of OpenSSL

namespace cad2slam {

/// SHA-256 of bytes that come piece by piece.
class Sha256 {
 public:
  Sha256();
  void add(const void* bytes, std::size_t count);
  /// As 64 lower-case hex digits. The end: nothing can be added any more.
  [[nodiscard]] std::string finish();

 private:
  struct Free {
    void operator()(evp_md_ctx_st* context) const;
  };
  std::unique_ptr<evp_md_ctx_st, Free> context_;
};

/// SHA-256 as 64 lower-case hex digits.
[[nodiscard]] std::string sha256Hex(const void* bytes, std::size_t count);
[[nodiscard]] Result<std::string> sha256HexOfFile(const std::filesystem::path& path);

}  // namespace cad2slam
