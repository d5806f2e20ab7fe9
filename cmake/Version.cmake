# SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
# SPDX-License-Identifier: Apache-2.0

# #include "app/version.h" for whoever links this.
configure_file(${CMAKE_SOURCE_DIR}/app/version.h.in ${CMAKE_BINARY_DIR}/generated/app/version.h @ONLY)
add_library(cad2slam_version INTERFACE)
target_include_directories(cad2slam_version INTERFACE ${CMAKE_BINARY_DIR}/generated)
