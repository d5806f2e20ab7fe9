# SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
# SPDX-License-Identifier: Apache-2.0

# Warnings of our own code only: link this target PRIVATE.
add_library(cad2slam_warnings INTERFACE)
target_compile_options(cad2slam_warnings INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Wnon-virtual-dtor -Woverloaded-virtual
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>  # g++ 12 sees overlaps in string concatenation that are not there (GCC 105651)
  $<$<BOOL:${CAD2SLAM_WARNINGS_AS_ERRORS}>:-Werror>)
