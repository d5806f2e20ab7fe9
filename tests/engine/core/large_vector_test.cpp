// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/core/large_vector.h"

#include <QtTest>

#include <cstdint>
#include <numeric>

using namespace cad2slam;

class LargeVectorTest : public QObject {
  Q_OBJECT

 private slots:
  void sizesAroundTheLimitHoldTheirNumbers() {
    for (const std::size_t count : {std::size_t{1}, std::size_t{524287}, std::size_t{524288}, std::size_t{3000001}}) {
      LargeVector<std::uint64_t> numbers(count);
      std::iota(numbers.begin(), numbers.end(), std::uint64_t{7});
      QCOMPARE(numbers.front(), std::uint64_t{7});
      QCOMPARE(numbers.back(), std::uint64_t{6 + count});
      const LargeVector<std::uint64_t> moved = std::move(numbers);
      QCOMPARE(moved.size(), count);
      QCOMPARE(moved[count / 2], std::uint64_t{7 + count / 2});
    }
  }

  void growingCrossesTheLimit() {
    LargeVector<std::uint32_t> numbers;
    for (std::uint32_t k = 0; k < 3000000; ++k) numbers.push_back(k);
    for (std::uint32_t k = 0; k < 3000000; k += 999) QCOMPARE(numbers[k], k);
  }

  void freedMemoryIsGone() {
    LargeVector<std::uint32_t> numbers(3000000);
    freeMemory(numbers);
    QVERIFY(numbers.empty());
    QCOMPARE(numbers.capacity(), std::size_t{0});
  }

  void typesKeepTheirAlignment() {
    struct alignas(64) Line {
      char bytes[64];
    };
    for (const std::size_t count : {std::size_t{1}, std::size_t{100}, std::size_t{100000}}) {
      const LargeVector<Line> lines(count);
      QCOMPARE(reinterpret_cast<std::uintptr_t>(lines.data()) % 64, std::uintptr_t{0});
    }
  }

  void impossibleSizesAreNoOverflow() {
    LargeAllocator<std::uint64_t> allocator;
    QVERIFY_EXCEPTION_THROWN(static_cast<void>(allocator.allocate(~std::size_t{0} / 4)), std::bad_alloc);
    QVERIFY_EXCEPTION_THROWN(static_cast<void>(allocator.allocate(std::size_t{1} << 57)), std::bad_alloc);
  }
};

QTEST_APPLESS_MAIN(LargeVectorTest)
#include "large_vector_test.moc"
