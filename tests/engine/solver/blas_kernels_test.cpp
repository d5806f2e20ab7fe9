// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/solver/blas_kernels.h"

#include <QTest>

#include <Eigen/Core>

#include <cstdlib>
#include <string>

#include "cad2slam/solver/blas.h"
#include "cad2slam/solver/loaded_function.h"

namespace cad2slam {
namespace {

std::string kernels() {
  auto* const name = loadedFunction<char*()>("openblas_get_corename");
  return name != nullptr ? name() : "";
}

/// The product by BLAS differs from Eigen's by rounding only.
bool multipliesRight() {
  constexpr int kColumns = 16;
  const Eigen::MatrixXd matrix = Eigen::MatrixXd::Random(123, 77);
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, kColumns, Eigen::RowMajor>;
  const Rows rows = Rows::Random(77, kColumns);
  Rows product(123, kColumns);
  multiply<kColumns>(matrix.data(), 123, 123, 77, rows.data(), product.data());
  return (product - matrix.lazyProduct(rows)).cwiseAbs().maxCoeff() < 1e-12;
}

}  // namespace

class BlasKernelsTest : public QObject {
  Q_OBJECT
 private slots:
  void oldKernelsAreReplaced();
  void aChosenOneStays();
};

void BlasKernelsTest::aChosenOneStays() {
  if (kernels().empty()) QSKIP("The BLAS of this system is not OpenBLAS");
  const std::string before = kernels();
  setenv("OPENBLAS_CORETYPE", "Prescott", 1);
  fitBlasToProcessor();
  QCOMPARE(std::getenv("OPENBLAS_CORETYPE"), "Prescott");
  unsetenv("OPENBLAS_CORETYPE");
  QCOMPARE(kernels(), before);
  QVERIFY(multipliesRight());
}

void BlasKernelsTest::oldKernelsAreReplaced() {
  if (kernels().empty()) QSKIP("The BLAS of this system is not OpenBLAS");
#if defined(__x86_64__)
  if (!__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("fma")) QSKIP("This processor has no AVX2");
  // As on a processor that OpenBLAS does not know.
  auto* const forget = loadedFunction<void()>("gotoblas_dynamic_quit");
  auto* const choose = loadedFunction<void()>("gotoblas_dynamic_init");
  if (forget == nullptr || choose == nullptr) QSKIP("This OpenBLAS has kernels for one processor only");
  setenv("OPENBLAS_CORETYPE", "Prescott", 1);
  forget();
  choose();
  unsetenv("OPENBLAS_CORETYPE");
  QCOMPARE(kernels(), std::string("Prescott"));
  QVERIFY(multipliesRight());
  fitBlasToProcessor();
  QVERIFY2(kernels() == "SkylakeX" || kernels() == "Haswell" || kernels() == "Cooperlake", kernels().c_str());
  QVERIFY(multipliesRight());
  QVERIFY(std::getenv("OPENBLAS_CORETYPE") == nullptr);
#else
  QSKIP("OpenBLAS chooses well on other processors");
#endif
}

}  // namespace cad2slam

QTEST_GUILESS_MAIN(cad2slam::BlasKernelsTest)
#include "blas_kernels_test.moc"
