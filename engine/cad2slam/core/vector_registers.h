// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace cad2slam {

/// Clears the upper halves of the vector registers of the calling thread, which code for AVX may have left in use. With
/// them in use, each SSE instruction waits for the one before that wrote the same register, and what a compiler makes
/// of plain C++ on x86-64 is SSE: a solve then takes three times as long (measured with AVX-512). A new thread inherits
/// them from the one that starts it, so this is the first thing that a thread for long work does.
/// Does nothing on a processor that has no such halves.
void clearUpperVectorHalves();

}  // namespace cad2slam
