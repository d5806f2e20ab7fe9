// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/mesh/tile_index.h"

#include <algorithm>
#include <limits>

namespace cad2slam {
namespace {

double squaredDistanceToSquare(const Eigen::Vector2d& point, double left, double bottom, double side) {
  const double dx = std::max({left - point.x(), 0.0, point.x() - (left + side)});
  const double dy = std::max({bottom - point.y(), 0.0, point.y() - (bottom + side)});
  return dx * dx + dy * dy;
}

}  // namespace

std::optional<TileIndex> TileIndex::create(const TileLattice& lattice, const TileCoordinate* tiles, std::size_t count) {
  TileIndex index;
  index.lattice_ = lattice;
  for (std::size_t node = 0; node < count; ++node) {
    if (!index.insert(tiles[node], static_cast<std::uint32_t>(node))) return std::nullopt;
  }
  return index;
}

std::array<std::uint32_t, 9> TileIndex::neighbourhood(std::int32_t column, std::int32_t row) const {
  std::array<std::uint32_t, 9> nodes;
  const std::int32_t inner_column = column & kMask;
  const std::int32_t inner_row = row & kMask;
  if (inner_column >= 1 && inner_column < kMask && inner_row >= 1 && inner_row < kMask) {
    // All nine tiles share a block: one look-up in the table, and one count for each row of three.
    const Slot* slot = findSlot(column >> kShift, row >> kShift);
    if (slot == nullptr) {
      nodes.fill(kNone);
      return nodes;
    }
    std::int32_t inner = ((inner_row - 1) << kShift) + inner_column - 1;
    if (!nodes_of_blocks_.empty()) {
      for (std::size_t k = 0; k < 9; ++k)
        nodes[k] = nodeIn(*slot, inner + static_cast<std::int32_t>(k / 3 * 8 + k % 3));
      return nodes;
    }
    for (std::size_t k = 0; k < 9; k += 3, inner += 1 << kShift) {
      std::uint32_t next = slot->first_node + countBelow(slot->occupied, inner);
      for (std::int32_t dx = 0; dx < 3; ++dx) {
        const bool is_there = (slot->occupied >> (inner + dx) & 1U) != 0;
        nodes[k + static_cast<std::size_t>(dx)] = is_there ? next : kNone;
        next += is_there ? 1 : 0;
      }
    }
    return nodes;
  }
  std::size_t k = 0;
  for (std::int32_t dy = -1; dy <= 1; ++dy) {
    for (std::int32_t dx = -1; dx <= 1; ++dx) nodes[k++] = at(column + dx, row + dy);
  }
  return nodes;
}

TileCoordinate TileIndex::nearestTile(const Eigen::Vector2d& cells) const {
  TileCoordinate best;
  double best_squared = std::numeric_limits<double>::infinity();
  const auto consider = [&](const TileCoordinate& tile) {
    const double squared = squaredDistanceToSquare(cells, tile.column, tile.row, 1.0);
    if (squared >= best_squared) return;
    best_squared = squared;
    best = tile;
  };
  constexpr double kTileLimit = 1e9;
  constexpr std::int32_t kRings = 8;
  if (cells.cwiseAbs().maxCoeff() < kTileLimit) {
    const auto column = static_cast<std::int32_t>(std::floor(cells.x()));
    const auto row = static_cast<std::int32_t>(std::floor(cells.y()));
    for (std::int32_t ring = 0; ring <= kRings; ++ring) {
      // Every tile of this ring is at least ring - 1 cells away.
      if ((ring - 1.0) * std::abs(ring - 1.0) >= best_squared) return best;
      for (std::int32_t dy = -ring; dy <= ring; ++dy) {
        const std::int32_t step = std::abs(dy) == ring ? 1 : std::max(1, 2 * ring);
        for (std::int32_t dx = -ring; dx <= ring; dx += step) {
          if (at(column + dx, row + dy) != kNone) consider({column + dx, row + dy});
        }
      }
    }
  }
  constexpr double kBlockSide = 1 << kShift;
  for (const Slot& slot : slots_) {
    if (slot.block == kNone) continue;
    if (squaredDistanceToSquare(cells, kBlockSide * slot.column, kBlockSide * slot.row, kBlockSide) >= best_squared) {
      continue;
    }
    for (std::int32_t inner = 0; inner < static_cast<std::int32_t>(kBlockTiles); ++inner) {
      if ((slot.occupied >> inner & 1U) == 0) continue;
      consider({(slot.column << kShift) | (inner & kMask), (slot.row << kShift) | (inner >> kShift)});
    }
  }
  return best;
}

LargeVector<std::uint32_t> TileIndex::renumberInMemoryOrder() {
  LargeVector<std::uint32_t> first_nodes(block_count_);
  LargeVector<std::uint32_t> old_numbers;
  old_numbers.reserve(node_count_);
  for (std::size_t block = 0; block < block_count_; ++block) {
    first_nodes[block] = static_cast<std::uint32_t>(old_numbers.size());
    for (std::size_t inner = 0; inner < kBlockTiles; ++inner) {
      const std::uint32_t node = nodes_of_blocks_[block * kBlockTiles + inner];
      if (node != kNone) old_numbers.push_back(node);
    }
  }
  for (Slot& slot : slots_) {
    if (slot.block != kNone) slot.first_node = first_nodes[slot.block];
  }
  freeMemory(nodes_of_blocks_);
  return old_numbers;
}

bool TileIndex::insert(const TileCoordinate& tile, std::uint32_t node) {
  if ((block_count_ + 1) * 2 > slots_.size()) grow();
  const std::int32_t block_column = tile.column >> kShift;
  const std::int32_t block_row = tile.row >> kShift;
  std::size_t at = hash(block_column, block_row) & slot_mask_;
  while (slots_[at].block != kNone && (slots_[at].column != block_column || slots_[at].row != block_row)) {
    at = (at + 1) & slot_mask_;
  }
  Slot& slot = slots_[at];
  if (slot.block == kNone) {
    slot = {block_column, block_row, static_cast<std::uint32_t>(block_count_++), 0, 0};
    nodes_of_blocks_.resize(block_count_ * kBlockTiles, kNone);
  }
  const std::int32_t inner = ((tile.row & kMask) << kShift) | (tile.column & kMask);
  if ((slot.occupied >> inner & 1U) != 0) return false;
  slot.occupied |= std::uint64_t{1} << inner;
  ++node_count_;
  nodes_of_blocks_[slot.block * kBlockTiles + static_cast<std::size_t>(inner)] = node;
  return true;
}

void TileIndex::grow() {
  LargeVector<Slot> old(slots_.empty() ? 16 : slots_.size() * 2);
  old.swap(slots_);
  slot_mask_ = slots_.size() - 1;
  for (const Slot& slot : old) {
    if (slot.block == kNone) continue;
    std::size_t at = hash(slot.column, slot.row) & slot_mask_;
    while (slots_[at].block != kNone) at = (at + 1) & slot_mask_;
    slots_[at] = slot;
  }
}

}  // namespace cad2slam
