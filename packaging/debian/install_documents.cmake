# SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
# SPDX-License-Identifier: Apache-2.0

# Runs at install time. In: package, version, source_dir; CMake's CMAKE_INSTALL_PREFIX.
# Writes /usr/share/doc/<package>: copyright, changelog.gz and, where programs hold code of other libraries, their
# licences as Debian ships them.
include(${source_dir}/packaging/reproducible.cmake)
cad2slam_set_source_date_epoch(${source_dir})
set(documents $ENV{DESTDIR}${CMAKE_INSTALL_PREFIX}/share/doc/${package})
file(MAKE_DIRECTORY ${documents})

configure_file(${source_dir}/packaging/debian/copyright ${documents}/copyright COPYONLY)

string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC) # of SOURCE_DATE_EPOCH where that is set
configure_file(${source_dir}/packaging/debian/changelog.in ${documents}/changelog @ONLY)
execute_process(COMMAND gzip -9 -n -f ${documents}/changelog COMMAND_ERROR_IS_FATAL ANY)

set(compiled_in)
if(package STREQUAL "cad2slam" OR package STREQUAL "cad2slam-cli")
  set(compiled_in libceres-dev libcli11-dev libeigen3-dev libexpected-dev nlohmann-json3-dev)
elseif(package MATCHES "^libcad2slam")
  set(compiled_in libeigen3-dev libexpected-dev nlohmann-json3-dev)
endif()
foreach(library ${compiled_in})
  if(EXISTS /usr/share/doc/${library}/copyright)
    configure_file(/usr/share/doc/${library}/copyright ${documents}/third-party/${library}.copyright COPYONLY)
  endif()
endforeach()
