// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

// The two BLAS routines we call, by the names that every BLAS exports (Debian has no one header for them). The lengths
// of the character arguments come last, as Fortran compilers pass them.
extern "C" {
void dtrsm_(const char* side, const char* triangle, const char* transposed, const char* unit_diagonal, const int* rows,
            const int* columns, const double* factor, const double* a, const int* a_stride, double* b,
            const int* b_stride, std::size_t, std::size_t, std::size_t, std::size_t);
void dgemm_(const char* a_transposed, const char* b_transposed, const int* rows, const int* columns, const int* inner,
            const double* factor, const double* a, const int* a_stride, const double* b, const int* b_stride,
            const double* c_factor, double* c, const int* c_stride, std::size_t, std::size_t);
}

namespace cad2slam {

// A row-major block of `kColumns` columns is for BLAS its transposed, column-major.

/// rows := lower^-1 rows, where `lower` is column-major with `stride`, and `rows` is n x kColumns, row-major.
template <int kColumns>
void solveLowerInPlace(const double* lower, int stride, int n, double* rows) {
  const int columns = kColumns;
  const double one = 1.0;
  dtrsm_("R", "L", "T", "N", &columns, &n, &one, lower, &stride, rows, &columns, 1, 1, 1, 1);
}

/// product := matrix rows, where `matrix` is m x n, column-major with `stride`; `rows` is n x kColumns and `product`
/// m x kColumns, both row-major.
template <int kColumns>
void multiply(const double* matrix, int stride, int m, int n, const double* rows, double* product) {
  const int columns = kColumns;
  const double one = 1.0;
  const double zero = 0.0;
  dgemm_("N", "T", &columns, &m, &n, &one, rows, &columns, matrix, &stride, &zero, product, &columns, 1, 1);
}

}  // namespace cad2slam
