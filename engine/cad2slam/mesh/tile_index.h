// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <optional>

#include "cad2slam/core/large_vector.h"
#include "cad2slam/mesh/tile_lattice.h"

namespace cad2slam {

/// Finds the node of a tile in constant time, whatever the extent of the lattice: a hash table of blocks of 8 x 8
/// tiles. Memory grows with the number of occupied blocks, so tiles that are far apart (or lie in a hostile file) cost
/// nothing. Nodes numbered in memory order are found by counting the occupied tiles before them, without a second
/// table: at random places of a large mesh that is one wait for memory less.
class TileIndex {
 public:
  static constexpr std::uint32_t kNone = 0xffffffffU;

  TileIndex() = default;
  /// nullopt when a tile stands twice.
  [[nodiscard]] static std::optional<TileIndex> create(const TileLattice& lattice, const TileCoordinate* tiles,
                                                       std::size_t count);

  [[nodiscard]] const TileLattice& lattice() const { return lattice_; }

  /// Node of a tile, or kNone.
  [[nodiscard]] std::uint32_t at(std::int32_t column, std::int32_t row) const {
    const Slot* slot = findSlot(column >> kShift, row >> kShift);
    return slot == nullptr ? kNone : nodeIn(*slot, ((row & kMask) << kShift) | (column & kMask));
  }

  /// The occupied tile nearest to a place given in continuous tile coordinates [cells], measured to the tile's square;
  /// the index must not be empty. Constant time near the mesh, linear in the number of blocks far from it.
  [[nodiscard]] TileCoordinate nearestTile(const Eigen::Vector2d& cells) const;

  /// Numbers the nodes anew in the order in which they lie in memory, so that neighbours share cache lines.
  /// Returns the old number of each new one.
  LargeVector<std::uint32_t> renumberInMemoryOrder();

  /// Nodes of the 3 x 3 tiles around a tile, row by row from the lower left; kNone where there is none.
  [[nodiscard]] std::array<std::uint32_t, 9> neighbourhood(std::int32_t column, std::int32_t row) const;

 private:
  static constexpr int kShift = 3;
  static constexpr std::int32_t kMask = (1 << kShift) - 1;
  static constexpr std::size_t kBlockTiles = std::size_t{1} << (2 * kShift);

  struct Slot {
    std::int32_t column = 0;
    std::int32_t row = 0;
    std::uint32_t block = kNone;
    std::uint32_t first_node = 0;  ///< once numbered in memory order
    std::uint64_t occupied = 0;    ///< one bit for each tile, row by row
  };

  [[nodiscard]] const Slot* findSlot(std::int32_t block_column, std::int32_t block_row) const {
    if (slots_.empty()) return nullptr;
    for (std::size_t at = hash(block_column, block_row) & slot_mask_;; at = (at + 1) & slot_mask_) {
      const Slot& slot = slots_[at];
      if (slot.block == kNone) return nullptr;
      if (slot.column == block_column && slot.row == block_row) return &slot;
    }
  }
  /// Node of tile `inner` of a block, or kNone.
  [[nodiscard]] std::uint32_t nodeIn(const Slot& slot, std::int32_t inner) const {
    if ((slot.occupied >> inner & 1U) == 0) return kNone;
    if (!nodes_of_blocks_.empty()) return nodes_of_blocks_[slot.block * kBlockTiles + static_cast<std::size_t>(inner)];
    return slot.first_node + countBelow(slot.occupied, inner);
  }
  /// Set bits below bit `inner`. Not every processor that Debian supports has an instruction for it.
  static std::uint32_t countBelow(std::uint64_t bits, std::int32_t inner) {
    bits &= (std::uint64_t{1} << inner) - 1;
    bits -= bits >> 1 & 0x5555555555555555ULL;
    bits = (bits & 0x3333333333333333ULL) + (bits >> 2 & 0x3333333333333333ULL);
    bits = (bits + (bits >> 4)) & 0x0f0f0f0f0f0f0f0fULL;
    return static_cast<std::uint32_t>(bits * 0x0101010101010101ULL >> 56);
  }
  static std::size_t hash(std::int32_t column, std::int32_t row) {
    const std::uint64_t key =
        (static_cast<std::uint64_t>(static_cast<std::uint32_t>(column)) << 32) | static_cast<std::uint32_t>(row);
    const std::uint64_t mixed = key * 0x9e3779b97f4a7c15ULL;
    return static_cast<std::size_t>(mixed ^ (mixed >> 32));
  }
  /// False when the tile stands twice.
  [[nodiscard]] bool insert(const TileCoordinate& tile, std::uint32_t node);
  void grow();

  TileLattice lattice_;
  LargeVector<Slot> slots_;  // open addressing, size is a power of two, at most half full
  std::size_t slot_mask_ = 0;
  std::size_t block_count_ = 0;
  std::size_t node_count_ = 0;
  LargeVector<std::uint32_t> nodes_of_blocks_;  // empty once the nodes are numbered in memory order
};

}  // namespace cad2slam
