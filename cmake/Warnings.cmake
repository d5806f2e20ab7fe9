# SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
# SPDX-License-Identifier: Apache-2.0

# Warnings of our own code only: link this target PRIVATE.
add_library(cad2slam_warnings INTERFACE)
target_compile_options(cad2slam_warnings INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Wnon-virtual-dtor -Woverloaded-virtual
  $<$<BOOL:${CAD2SLAM_WARNINGS_AS_ERRORS}>:-Werror>)
