# SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
# SPDX-License-Identifier: Apache-2.0

if(CAD2SLAM_HARDENING)
  add_compile_definitions(_GLIBCXX_ASSERTIONS)
endif()

if(CAD2SLAM_SANITIZE)
  add_compile_options(-fsanitize=${CAD2SLAM_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  add_link_options(-fsanitize=${CAD2SLAM_SANITIZE})
  # Under ASan Eigen aligns memory by hand, but Debian's libceres does not: a matrix allocated there and freed here
  # would be a false heap-buffer-overflow. glibc's malloc is 16-byte aligned, which is all that Eigen needs here.
  add_compile_definitions(EIGEN_MALLOC_ALREADY_ALIGNED=1)
  if(CAD2SLAM_BUILD_FUZZERS)
    add_compile_options(-fsanitize=fuzzer-no-link)
  endif()
endif()
