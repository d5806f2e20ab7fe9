// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace cad2slam {

/// While it lives, CHOLMOD works on the calling thread alone: the threads that BLAS and OpenMP start for each of the
/// thousands of small blocks of a mesh wait for each other longer than they work (a warm solve of 3 752 nodes takes
/// twice the time on two cores). The thread is made fit for arithmetic as well, see clearUpperVectorHalves().
class OneThread {
 public:
  OneThread();
  ~OneThread();
  OneThread(const OneThread&) = delete;
  OneThread& operator=(const OneThread&) = delete;

 private:
  int openmp_levels_ = 0;
};

}  // namespace cad2slam
