// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <utility>

#include <tl/expected.hpp>

namespace cad2slam {

enum class ErrorCode {
  kNotFound,      ///< a file or a named thing does not exist
  kUnreadable,    ///< it exists, but cannot be opened or read
  kUnwritable,    ///< it cannot be created, written or replaced; what was there before still is
  kMalformed,     ///< it was read, but does not say what it should
  kOutOfDomain,   ///< a value lies outside what the operation is defined for
  kDegenerate,    ///< the geometry does not determine an answer
  kNotConverged,  ///< the optimisation ended without a usable minimum
  kCancelled,     ///< the caller asked to stop
  kInternal,      ///< a broken contract or an exhausted resource
};

/// Why something a user, a file or a geometry asked for could not be done.
struct Error {
  ErrorCode code = ErrorCode::kMalformed;
  std::string message;  ///< one sentence a user can act on; no trailing period
  std::string where;    ///< "maps/eiii.yaml:7", "anchor 12", or empty

  /// `where: message`, or only the message where no place is known.
  [[nodiscard]] std::string sentence() const { return where.empty() ? message : where + ": " + message; }
};

template <class T = void>
using Result = tl::expected<T, Error>;

[[nodiscard]] inline tl::unexpected<Error> fail(ErrorCode code, std::string message, std::string where = {}) {
  return tl::unexpected<Error>(Error{code, std::move(message), std::move(where)});
}

/// Passes the error of one Result on as the error of another.
template <class T>
[[nodiscard]] tl::unexpected<Error> failAs(const Result<T>& failed) {
  return tl::unexpected<Error>(failed.error());
}

}  // namespace cad2slam
