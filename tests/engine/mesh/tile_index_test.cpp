// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include <QtTest>

#include <limits>
#include <map>
#include <random>

#include "cad2slam/mesh/tile_index.h"

namespace cad2slam {
namespace {

std::vector<TileCoordinate> randomTiles(std::size_t count, std::int32_t extent, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_int_distribution<std::int32_t> coordinate(-extent, extent);
  std::map<std::pair<std::int32_t, std::int32_t>, bool> seen;
  std::vector<TileCoordinate> tiles;
  while (tiles.size() < count) {
    const TileCoordinate tile{coordinate(random), coordinate(random)};
    if (seen.emplace(std::pair(tile.column, tile.row), true).second) tiles.push_back(tile);
  }
  return tiles;
}

double squaredDistance(const Eigen::Vector2d& cells, const TileCoordinate& tile) {
  const Eigen::Vector2d low(tile.column, tile.row);
  const Eigen::Vector2d nearest = cells.cwiseMax(low).cwiseMin(Eigen::Vector2d(low.array() + 1.0));
  return (cells - nearest).squaredNorm();
}

}  // namespace

class TileIndexTest : public QObject {
  Q_OBJECT
 private slots:
  void findsEveryTileAndNothingElse();
  void refusesATileTwice();
  void hostileCoordinatesCostNothing();
  void neighbourhoodAgreesWithSingleLookUps();
  void nearestTileAgreesWithBruteForce();
  void memoryOrderIsAPermutation();
};

void TileIndexTest::findsEveryTileAndNothingElse() {
  const std::vector<TileCoordinate> tiles = randomTiles(3000, 60, 1);
  const auto index = TileIndex::create({}, tiles.data(), tiles.size());
  QVERIFY(index.has_value());
  std::map<std::pair<std::int32_t, std::int32_t>, std::uint32_t> expected;
  for (std::uint32_t k = 0; k < tiles.size(); ++k) expected[{tiles[k].column, tiles[k].row}] = k;
  for (std::int32_t column = -65; column <= 65; ++column) {
    for (std::int32_t row = -65; row <= 65; ++row) {
      const auto found = expected.find({column, row});
      QCOMPARE(index->at(column, row), found == expected.end() ? TileIndex::kNone : found->second);
    }
  }
}

void TileIndexTest::refusesATileTwice() {
  const std::vector<TileCoordinate> tiles{{1, 2}, {3, 4}, {1, 2}};
  QVERIFY(!TileIndex::create({}, tiles.data(), tiles.size()).has_value());
}

void TileIndexTest::hostileCoordinatesCostNothing() {
  constexpr std::int32_t kLargest = std::numeric_limits<std::int32_t>::max();
  constexpr std::int32_t kSmallest = std::numeric_limits<std::int32_t>::min();
  const std::vector<TileCoordinate> tiles{{kLargest, kSmallest}, {kSmallest, kLargest}, {0, 0}};
  const auto index = TileIndex::create({}, tiles.data(), tiles.size());
  QVERIFY(index.has_value());
  QCOMPARE(index->at(kLargest, kSmallest), 0U);
  QCOMPARE(index->at(kLargest, kLargest), TileIndex::kNone);
}

void TileIndexTest::neighbourhoodAgreesWithSingleLookUps() {
  const std::vector<TileCoordinate> tiles = randomTiles(1500, 30, 2);
  const auto index = TileIndex::create({}, tiles.data(), tiles.size());
  for (std::int32_t column = -32; column <= 32; ++column) {
    for (std::int32_t row = -32; row <= 32; ++row) {
      const auto around = index->neighbourhood(column, row);
      for (std::int32_t k = 0; k < 9; ++k) {
        QCOMPARE(around[static_cast<std::size_t>(k)], index->at(column + k % 3 - 1, row + k / 3 - 1));
      }
    }
  }
}

void TileIndexTest::nearestTileAgreesWithBruteForce() {
  const std::vector<TileCoordinate> tiles = randomTiles(60, 40, 3);
  const auto index = TileIndex::create({}, tiles.data(), tiles.size());
  std::mt19937 random(4);
  std::uniform_real_distribution<double> place(-90.0, 90.0);
  for (int k = 0; k < 5000; ++k) {
    const Eigen::Vector2d cells(place(random), place(random));
    double best = std::numeric_limits<double>::infinity();
    for (const TileCoordinate& tile : tiles) best = std::min(best, squaredDistance(cells, tile));
    QVERIFY(std::abs(squaredDistance(cells, index->nearestTile(cells)) - best) < 1e-9);
  }
}

void TileIndexTest::memoryOrderIsAPermutation() {
  const std::vector<TileCoordinate> tiles = randomTiles(500, 20, 5);
  auto index = TileIndex::create({}, tiles.data(), tiles.size());
  const auto old_numbers = index->renumberInMemoryOrder();
  QCOMPARE(old_numbers.size(), tiles.size());
  for (std::uint32_t k = 0; k < old_numbers.size(); ++k) {
    const TileCoordinate tile = tiles[old_numbers[k]];
    QCOMPARE(index->at(tile.column, tile.row), k);
  }
}

}  // namespace cad2slam

QTEST_GUILESS_MAIN(cad2slam::TileIndexTest)
#include "tile_index_test.moc"
