// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace cad2slam {

/// Lets OpenBLAS use AVX2 or AVX-512 on a processor that is newer than itself. It knows processors by their model
/// number, and takes those it does not know for one of 2004: with Debian 12's (0.3.21, of 2022) that are Intel's since
/// 2023 and AMD's since 2024, on which a solve takes 1.5 times as long.
///
/// To be called once, as the first thing in main(): what it sets is read from the environment, which no other thread
/// may read meanwhile, and nothing may compute. Leaves everything as it is where another BLAS is used, where OpenBLAS
/// chose well, or where the user has set OPENBLAS_CORETYPE.
void fitBlasToProcessor();

}  // namespace cad2slam
