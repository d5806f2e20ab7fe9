# SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
# SPDX-License-Identifier: Apache-2.0

# What nearly every source includes from elsewhere is parsed once for each library: parsing it is most of a build. Our
# own headers stay out. CMAKE_DISABLE_PRECOMPILE_HEADERS builds without, as the presets `package` and `tidy` do: a source
# that forgets an #include fails there.
set(CAD2SLAM_COMMON_HEADERS
  <algorithm> <cmath> <filesystem> <functional> <map> <memory> <optional> <string> <vector> <Eigen/Core> <Eigen/LU>)
set(CAD2SLAM_WINDOW_HEADERS ${CAD2SLAM_COMMON_HEADERS} <QtWidgets>)

if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  add_compile_options(-fpch-preprocess)  # so that ccache can look into precompiled headers
endif()
