// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "cad2slam/io/pose_protocol.h"
#include "fuzz/require.h"

using namespace cad2slam;

/// Whatever is asked, the answer is one line, and an id that is repeated is one that can be read again.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
  std::string id;
  const Result<PoseRequest> request = parsePoseRequest({reinterpret_cast<const char*>(bytes), count}, id);
  std::string answer;
  if (!request) {
    appendError(id, request.error(), answer);
  } else if (request->kind != PoseRequest::Kind::kInfo) {
    const std::vector<Projection> answers(request->poses.size());
    appendAnswer(*request, answers.data(), answer);
    fuzz::require(!request->single || request->poses.size() == 1, "a single request of several poses");
  }
  if (answer.empty()) return 0;
  fuzz::require(answer.front() == '{' && answer.back() == '\n', "no object on a line");
  fuzz::require(std::count(answer.begin(), answer.end(), '\n') == 1, "more than one line");
  if (id.empty()) return 0;
  std::string again;
  const Result<PoseRequest> info = parsePoseRequest("{\"op\":\"info\",\"id\":" + id + "}", again);
  fuzz::require(info.has_value() && again == id, "the id changes");
  return 0;
}
