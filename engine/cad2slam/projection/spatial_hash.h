// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "cad2slam/core/large_vector.h"

namespace cad2slam {

/// Finds points near a place in constant time: points are sorted into square buckets whose numbers are hashed into a
/// table as long as the list of points. Buckets that share a slot only cost a distance test.
class SpatialHash {
 public:
  /// The nearest points to a place, nearest first.
  struct Candidates {
    static constexpr std::size_t kCapacity = 8;
    std::array<std::uint32_t, kCapacity> nodes;
    std::array<double, kCapacity> squared_distances;
    std::size_t count = 0;
  };

  SpatialHash() = default;
  /// `point_at(i)` gives point i of `count`, and is asked twice: nothing is copied on the way.
  template <class PointAt>
  SpatialHash(std::size_t count, const PointAt& point_at, double bucket_size) : bucket_size_(bucket_size) {
    std::size_t slots = 16;
    while (slots < count) slots *= 2;
    mask_ = slots - 1;
    begin_.assign(slots + 1, 0);
    const auto slotOfPoint = [this](const Eigen::Vector2d& point) {
      return slotOf(bucketOf(point.x()), bucketOf(point.y()));
    };
    for (std::size_t i = 0; i < count; ++i) ++begin_[slotOfPoint(point_at(i))];
    // First the end of each slot; it moves down to the beginning while the points are put in from the last one on.
    for (std::size_t slot = 0; slot < slots; ++slot) begin_[slot + 1] += begin_[slot];
    entries_.resize(count);
    for (std::size_t i = count; i-- > 0;) {
      const Eigen::Vector2d point = point_at(i);
      entries_[--begin_[slotOfPoint(point)]] = {static_cast<float>(point.x()), static_cast<float>(point.y()),
                                                static_cast<std::uint32_t>(i)};
    }
  }

  /// Up to Candidates::kCapacity points of the four buckets whose common corner is nearest to the place: all points
  /// within half a bucket of it, and some up to one and a half.
  [[nodiscard]] Candidates near(const Eigen::Vector2d& place) const {
    Candidates found;
    const std::int64_t left = bucketOf(place.x() - 0.5 * bucket_size_);
    const std::int64_t bottom = bucketOf(place.y() - 0.5 * bucket_size_);
    std::array<std::size_t, 4> seen{};
    for (std::size_t k = 0; k < 4; ++k) {
      const std::size_t slot =
          slotOf(left + static_cast<std::int64_t>(k % 2), bottom + static_cast<std::int64_t>(k / 2));
      bool repeated = false;
      for (std::size_t j = 0; j < k; ++j) repeated = repeated || seen[j] == slot;
      seen[k] = slot;
      if (repeated) continue;
      for (std::uint32_t e = begin_[slot]; e < begin_[slot + 1]; ++e) offer(found, entries_[e], place);
    }
    return found;
  }

  /// The nearest of all points; linear in their number.
  [[nodiscard]] std::uint32_t nearest(const Eigen::Vector2d& place) const {
    std::uint32_t best = 0;
    double best_squared = std::numeric_limits<double>::infinity();
    for (const Entry& entry : entries_) {
      const double squared = squaredDistance(entry, place);
      if (squared < best_squared) {
        best_squared = squared;
        best = entry.node;
      }
    }
    return best;
  }

 private:
  struct Entry {
    float x;
    float y;
    std::uint32_t node;
  };

  static double squaredDistance(const Entry& entry, const Eigen::Vector2d& place) {
    const double dx = static_cast<double>(entry.x) - place.x();
    const double dy = static_cast<double>(entry.y) - place.y();
    return dx * dx + dy * dy;
  }

  void offer(Candidates& found, const Entry& entry, const Eigen::Vector2d& place) const {
    const double squared = squaredDistance(entry, place);
    if (squared > 2.25 * bucket_size_ * bucket_size_) return;  // from another bucket in the same slot
    if (found.count == Candidates::kCapacity && squared >= found.squared_distances[found.count - 1]) return;
    std::size_t at = found.count < Candidates::kCapacity ? found.count++ : found.count - 1;
    for (; at > 0 && found.squared_distances[at - 1] > squared; --at) {
      found.squared_distances[at] = found.squared_distances[at - 1];
      found.nodes[at] = found.nodes[at - 1];
    }
    found.squared_distances[at] = squared;
    found.nodes[at] = entry.node;
  }

  [[nodiscard]] std::int64_t bucketOf(double coordinate) const {
    const double bucket = std::floor(coordinate / bucket_size_);
    return std::abs(bucket) < 1e15 ? static_cast<std::int64_t>(bucket) : 0;
  }
  [[nodiscard]] std::size_t slotOf(std::int64_t x, std::int64_t y) const {
    std::uint64_t key = static_cast<std::uint64_t>(x) * 0x9e3779b97f4a7c15ULL;
    key = (key ^ (key >> 29)) + static_cast<std::uint64_t>(y) * 0xbf58476d1ce4e5b9ULL;
    return static_cast<std::size_t>((key ^ (key >> 32)) & mask_);
  }

  double bucket_size_ = 1.0;
  std::size_t mask_ = 0;
  LargeVector<std::uint32_t> begin_;
  LargeVector<Entry> entries_;
};

}  // namespace cad2slam
