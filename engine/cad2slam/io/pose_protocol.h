// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cad2slam/core/result.h"
#include "cad2slam/projection/projector.h"

namespace cad2slam {

/// "inside", "extrapolated", "outside", "folded", "invalid": as all text interfaces call them.
[[nodiscard]] std::string_view nameOf(ProjectionStatus status);

/// One line that another process sends:
///     {"id": 7, "op": "project", "poses": [[x, y, heading], ...], "outside": "rigid"}
/// `op` is project (blueprint to SLAM), unproject (back) or info; `pose` in place of `poses` asks for a single one; the
/// heading, `id` (a text, number or null) and `outside` may be left out.
struct PoseRequest {
  enum class Kind { kProject, kUnproject, kInfo };
  Kind kind = Kind::kInfo;
  std::string id;  ///< as it is to be repeated, a JSON value; empty when there was none
  std::vector<Pose2> poses;
  bool single = false;
  std::optional<OutsidePolicy> outside;
};

/// The request, or why it is none. `id` is set as far as it was read, so that an error can be told to whom it concerns.
[[nodiscard]] Result<PoseRequest> parsePoseRequest(std::string_view line, std::string& id);

/// Answers append one line with its end to `out`:
///     {"id": 7, "poses": [[x, y, heading], null, ...], "status": ["inside", "outside", ...]}
/// A pose without an answer is null. `pose` and a single status for a single one.
void appendAnswer(const PoseRequest& request, const Projection* answers, std::string& out);
///     {"id": 7, "info": {...}}
void appendInfo(const PoseRequest& request, const Projector& projector, std::string& out);
///     {"id": 7, "error": {"code": "malformed", "message": "..."}}
void appendError(const std::string& id, const Error& error, std::string& out);

}  // namespace cad2slam
