# SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
# SPDX-License-Identifier: Apache-2.0

# clang-tidy reads the nearest .clang-tidy above a file, which for generated sources (moc, resources) is this one:
# a single check that they cannot fail, as an empty list is an error.
if(CMAKE_CXX_CLANG_TIDY)
  file(WRITE ${CMAKE_BINARY_DIR}/.clang-tidy "Checks: '-*,llvm-twine-local'\n")
endif()
