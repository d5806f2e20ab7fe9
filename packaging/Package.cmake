# SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
# SPDX-License-Identifier: Apache-2.0

# `cpack` in the build folder makes one Debian package for each component of Install.cmake.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME cad2slam)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "") # each package has its own
set(CPACK_PACKAGE_CONTACT "The CAD2SLAM authors <maintainers@cad2slam.org>")
set(CPACK_PACKAGE_VENDOR "The CAD2SLAM authors")
set(CPACK_PACKAGE_DIRECTORY ${CMAKE_BINARY_DIR}/packages)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_SET_DESTDIR OFF)
set(CPACK_STRIP_FILES ON)
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
# Runs when cpack runs: SOURCE_DATE_EPOCH from the commit that is packaged.
set(CPACK_PROJECT_CONFIG_FILE ${CMAKE_CURRENT_LIST_DIR}/reproducible.cmake)
set(CPACK_CAD2SLAM_SOURCE_DIR ${CMAKE_SOURCE_DIR})

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_COMPONENTS_ALL dev lib python)

# One package: its component, Debian name, section, and description (one line of summary, then wrapped text).
macro(cad2slam_package component name section description)
  string(TOUPPER ${component} upper)
  set(CPACK_COMPONENT_${upper}_DESCRIPTION "${description}")
  set(CPACK_DEBIAN_${upper}_PACKAGE_NAME ${name})
  set(CPACK_DEBIAN_${upper}_PACKAGE_SECTION ${section})
  # Debian's changelog and copyright of the package, and the licences of libraries that are compiled in.
  install(CODE "set(package ${name})\nset(version ${PROJECT_VERSION})\nset(source_dir [[${CMAKE_SOURCE_DIR}]])"
          COMPONENT ${component})
  install(SCRIPT ${CMAKE_CURRENT_LIST_DIR}/debian/install_documents.cmake COMPONENT ${component})
endmacro()

cad2slam_package(lib libcad2slam0 libs
"projects poses between building blueprints and SLAM maps: C library
Reads a projector file made by CAD2SLAM and projects poses from the blueprint
of a building into the SLAM map of a robot and back. Thread-safe, without
allocation in a query; for C and every language that calls C.")
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_LIB_PACKAGE_CONTROL_EXTRA ${CMAKE_CURRENT_LIST_DIR}/debian/triggers)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS_POLICY ">=")

cad2slam_package(dev libcad2slam-dev libdevel
"projects poses between building blueprints and SLAM maps: development
Headers, static C++ library and link to the C library with which robots read
projector files made by CAD2SLAM. C++17 and later; needs neither Ceres nor
OpenCV nor Qt.")
set(CPACK_DEBIAN_DEV_PACKAGE_DEPENDS
    "libcad2slam0 (= ${PROJECT_VERSION}), libeigen3-dev, libexpected-dev, libssl-dev")

cad2slam_package(python python3-cad2slam python
"projects poses between building blueprints and SLAM maps: Python module
Reads a projector file made by CAD2SLAM and projects poses from the blueprint
of a building into the SLAM map of a robot and back, many at once with numpy.
Single poses are faster with libcad2slam0 installed.")
set(CPACK_DEBIAN_PYTHON_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "python3 (>= 3.9), python3-numpy")
set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS "libcad2slam0 (>= ${PROJECT_VERSION})")

if(TARGET cad2slam_cli)
  list(APPEND CPACK_COMPONENTS_ALL cli)
  cad2slam_package(cli cad2slam-cli science
"joins building blueprints and robot SLAM maps: command line
From a list of anchors, fits a deformable mesh that takes the blueprint of a
building into the SLAM map of a robot, and writes it as a projector file.
Projects poses both ways and warps whole maps. For robots, servers and
scripts; needs no display.")
  set(CPACK_DEBIAN_CLI_PACKAGE_RECOMMENDS "libopenblas0-pthread | libopenblas0")
endif()

if(TARGET cad2slam_app)
  list(APPEND CPACK_COMPONENTS_ALL app)
  cad2slam_package(app cad2slam science
"joins building blueprints and robot SLAM maps: desktop program
Shows the blueprint of a building beside the SLAM map of a robot. The
installer clicks places that both show; a mesh is fitted to them at every
edit, and the projector file at the end takes poses between both maps.")
  set(CPACK_DEBIAN_APP_PACKAGE_RECOMMENDS "libopenblas0-pthread | libopenblas0, qt6-qpa-plugins, qt6-translations-l10n")
  set(CPACK_DEBIAN_APP_PACKAGE_SUGGESTS cad2slam-cli)
endif()

include(CPack)
