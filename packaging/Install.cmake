# SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
# SPDX-License-Identifier: Apache-2.0

# Which file belongs to which component; each component is a Debian package (Package.cmake).
#   app   the desktop program        cli   the command line program
#   lib   the C library for robots   python  the Python modules
#   dev   the libraries for robots, to compile against
include(CMakePackageConfigHelpers)
find_program(GZIP_PROGRAM gzip REQUIRED)

# The date of this version, for manual pages and AppStream.
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/CHANGELOG.md)
string(REPLACE "." "\\." version_pattern ${PROJECT_VERSION})
file(STRINGS ${CMAKE_SOURCE_DIR}/CHANGELOG.md heading REGEX "^## \\[${version_pattern}\\] - ")
if(NOT heading MATCHES " - ([0-9]+-[0-9]+-[0-9]+)$")
  message(FATAL_ERROR "CHANGELOG.md has no line '## [${PROJECT_VERSION}] - YYYY-MM-DD'")
endif()
set(CAD2SLAM_RELEASE_DATE ${CMAKE_MATCH_1})

# Debian wants manual pages compressed, and the same bytes in every build (-n: no time).
function(cad2slam_install_manual program component)
  set(page ${CMAKE_CURRENT_BINARY_DIR}/${program}.1)
  configure_file(man/${program}.1.in ${page} @ONLY)
  add_custom_command(OUTPUT ${page}.gz DEPENDS ${page} VERBATIM
    COMMAND ${GZIP_PROGRAM} -9 -n -k -f ${page})
  add_custom_target(manual_${program} ALL DEPENDS ${page}.gz)
  install(FILES ${page}.gz DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT ${component})
endfunction()

# --- Command line program -------------------------------------------------------------------------------------------
if(TARGET cad2slam_cli)
  install(TARGETS cad2slam_cli RUNTIME COMPONENT cli)
  cad2slam_install_manual(cad2slam-cli cli)
endif()

# --- Desktop program ------------------------------------------------------------------------------------------------
if(TARGET cad2slam_app)
  install(TARGETS cad2slam_app RUNTIME COMPONENT app)
  cad2slam_install_manual(cad2slam app)
  install(FILES desktop/org.cad2slam.cad2slam.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications COMPONENT app)
  install(FILES desktop/org.cad2slam.cad2slam.mime.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages
          RENAME org.cad2slam.cad2slam.xml COMPONENT app)
  configure_file(desktop/org.cad2slam.cad2slam.metainfo.xml.in org.cad2slam.cad2slam.metainfo.xml @ONLY)
  install(FILES ${CMAKE_CURRENT_BINARY_DIR}/org.cad2slam.cad2slam.metainfo.xml
          DESTINATION ${CMAKE_INSTALL_DATADIR}/metainfo COMPONENT app)
  set(icons ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable)
  install(FILES desktop/icons/org.cad2slam.cad2slam.svg DESTINATION ${icons}/apps COMPONENT app)
  install(FILES desktop/icons/application-x-cad2slam-project.svg desktop/icons/application-x-cad2slam-projector.svg
          DESTINATION ${icons}/mimetypes COMPONENT app)
  if(EXISTS ${CMAKE_SOURCE_DIR}/sample_maps/office)
    install(DIRECTORY ${CMAKE_SOURCE_DIR}/sample_maps/office DESTINATION ${CMAKE_INSTALL_DATADIR}/cad2slam/sample_maps
            COMPONENT app)
  endif()
endif()

# --- Libraries for robots ---------------------------------------------------------------------------------------------
set(config_folder ${CMAKE_INSTALL_LIBDIR}/cmake/cad2slam)
install(TARGETS cad2slam_projector cad2slam_c EXPORT cad2slam
  ARCHIVE COMPONENT dev
  LIBRARY COMPONENT lib NAMELINK_COMPONENT dev
  FILE_SET HEADERS COMPONENT dev)
install(EXPORT cad2slam NAMESPACE cad2slam:: FILE cad2slamTargets.cmake DESTINATION ${config_folder} COMPONENT dev)
configure_package_config_file(cad2slamConfig.cmake.in cad2slamConfig.cmake INSTALL_DESTINATION ${config_folder}
  NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(cad2slamConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/cad2slamConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/cad2slamConfigVersion.cmake
        DESTINATION ${config_folder} COMPONENT dev)
set(docs ${CMAKE_SOURCE_DIR}/docs)
install(FILES ${docs}/projector-file.md ${docs}/example.c2s ${docs}/guide-nav2.md ${docs}/guide-open-rmf.md
              ${docs}/guide-vda5050.md
        DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/libcad2slam-dev COMPONENT dev)

# Where Debian's python3 looks; others install with pip from the folder python/.
install(FILES ${CMAKE_SOURCE_DIR}/python/cad2slam.py ${CMAKE_SOURCE_DIR}/python/cad2slam_native.py
              ${CMAKE_SOURCE_DIR}/python/c2s_rmf.py
        DESTINATION lib/python3/dist-packages COMPONENT python)
