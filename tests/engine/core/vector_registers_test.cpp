// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/core/vector_registers.h"

#include <QTest>

#include <cpuid.h>
#include <immintrin.h>

namespace cad2slam {
namespace {

constexpr unsigned kUpperHalves = 4;  // of the components of the processor's state

/// Whether the processor tells which parts of its state are in use (XGETBV with ECX = 1).
bool tellsWhatIsInUse() {
  unsigned a = 0;
  unsigned b = 0;
  unsigned c = 0;
  unsigned d = 0;
  return __builtin_cpu_supports("avx") && __get_cpuid_count(0xd, 1, &a, &b, &c, &d) != 0 && (a & 4) != 0;
}

unsigned partsInUse() {
  unsigned low = 0;
  unsigned high = 0;
  asm volatile("xgetbv" : "=a"(low), "=d"(high) : "c"(1));
  return low;
}

/// As code for AVX does that does not clean up behind itself, which compilers take care of.
void useUpperHalves() {
  asm volatile("vpcmpeqd %%xmm0, %%xmm0, %%xmm0\n\tvinsertf128 $1, %%xmm0, %%ymm0, %%ymm0" : : : "xmm0");
}

}  // namespace

class VectorRegistersTest : public QObject {
  Q_OBJECT
 private slots:
  void clearsWhatAvxLeft();
};

void VectorRegistersTest::clearsWhatAvxLeft() {
  if (!tellsWhatIsInUse()) QSKIP("This processor does not tell which of its registers are in use");
  useUpperHalves();
  const unsigned before = partsInUse();
  clearUpperVectorHalves();
  const unsigned after = partsInUse();
  QVERIFY((before & kUpperHalves) != 0);
  QVERIFY((after & kUpperHalves) == 0);
}

}  // namespace cad2slam

QTEST_GUILESS_MAIN(cad2slam::VectorRegistersTest)
#include "vector_registers_test.moc"
