// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstddef>
#include <system_error>
#include <thread>
#include <vector>

#include "cad2slam/projection/projector.h"

namespace cad2slam {
namespace {

template <class Query>
void projectAll(const Pose2* in, Projection* out, std::size_t count, unsigned threads, const Query& query) {
  constexpr std::size_t kWorthAThread = 4096;
  if (threads == 0) threads = std::max(1U, std::thread::hardware_concurrency());
  const std::size_t parts = std::clamp<std::size_t>(count / kWorthAThread, 1, threads);
  const auto part = [&](std::size_t k) {
    for (std::size_t i = count * k / parts; i < count * (k + 1) / parts; ++i) out[i] = query(in[i]);
  };
  std::vector<std::thread> workers;
  workers.reserve(parts - 1);
  try {
    while (workers.size() + 1 < parts) workers.emplace_back(part, workers.size() + 1);
  } catch (const std::system_error&) {
    // No thread to be had: this one does what is left.
  }
  for (std::size_t k = workers.size() + 1; k < parts; ++k) part(k);
  part(0);
  for (std::thread& worker : workers) worker.join();
}

}  // namespace

void Projector::slamFromBlueprint(const Pose2* in, Projection* out, std::size_t count, OutsidePolicy outside,
                                  unsigned threads) const {
  projectAll(in, out, count, threads, [&](const Pose2& pose) { return slamFromBlueprint(pose, outside); });
}

void Projector::blueprintFromSlam(const Pose2* in, Projection* out, std::size_t count, OutsidePolicy outside,
                                  unsigned threads) const {
  projectAll(in, out, count, threads, [&](const Pose2& pose) { return blueprintFromSlam(pose, outside); });
}

}  // namespace cad2slam
