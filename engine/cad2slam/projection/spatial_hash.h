// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include <algorithm>
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

  /// Whether `wanted(i)` holds for any point i within one bucket's side of the place.
  template <class Wanted>
  [[nodiscard]] bool anyAround(const Eigen::Vector2d& place, const Wanted& wanted) const {
    for (std::int64_t dy = -1; dy <= 1; ++dy) {
      for (std::int64_t dx = -1; dx <= 1; ++dx) {
        const std::size_t slot = slotOf(bucketOf(place.x()) + dx, bucketOf(place.y()) + dy);
        for (std::uint32_t e = begin_[slot]; e < begin_[slot + 1]; ++e) {
          if (squaredDistance(entries_[e], place) <= bucket_size_ * bucket_size_ && wanted(entries_[e].node))
            return true;
        }
      }
    }
    return false;
  }

  /// The nearest of all points: constant time within some buckets of them, linear in their number far away.
  [[nodiscard]] std::uint32_t nearest(const Eigen::Vector2d& place) const {
    constexpr std::int64_t kRings = 8;
    Nearest best;
    for (std::int64_t ring = 0; ring <= kRings; ++ring) {
      // What is not yet seen is at least ring - 1 buckets away.
      const double unseen = static_cast<double>(ring - 1) * bucket_size_;
      if (ring > 0 && unseen * unseen >= best.squared_distance) return best.node;
      for (std::int64_t dy = -ring; dy <= ring; ++dy) {
        const std::int64_t step = std::abs(dy) == ring ? 1 : 2 * ring;
        for (std::int64_t dx = -ring; dx <= ring; dx += std::max<std::int64_t>(1, step)) {
          const std::size_t slot = slotOf(bucketOf(place.x()) + dx, bucketOf(place.y()) + dy);
          for (std::uint32_t e = begin_[slot]; e < begin_[slot + 1]; ++e) best.offer(entries_[e], place);
        }
      }
    }
    for (const Entry& entry : entries_) best.offer(entry, place);
    return best.node;
  }

 private:
  struct Entry {
    float x;
    float y;
    std::uint32_t node;
  };

  struct Nearest {
    std::uint32_t node = 0;
    double squared_distance = std::numeric_limits<double>::infinity();

    void offer(const Entry& entry, const Eigen::Vector2d& place) {
      const double squared = squaredDistance(entry, place);
      if (squared >= squared_distance) return;
      squared_distance = squared;
      node = entry.node;
    }
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
