# SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
# SPDX-License-Identifier: Apache-2.0

# Ceres with the BLAS that the system has chosen: libblas.so.3, which is OpenBLAS where that is installed. Debian's
# libceres-dev brings ATLAS along and names it twice, in CMake's search for a BLAS and in Ceres's own target; linked,
# ATLAS takes all of CHOLMOD's calls whatever the system has chosen.
set(BLA_VENDOR Generic)
find_package(Ceres REQUIRED)
get_target_property(ceres_libraries Ceres::ceres INTERFACE_LINK_LIBRARIES)
list(FILTER ceres_libraries EXCLUDE REGEX "lib(f77blas|atlas)\\.so")
set_target_properties(Ceres::ceres PROPERTIES INTERFACE_LINK_LIBRARIES "${ceres_libraries}")
