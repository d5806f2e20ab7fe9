# SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
# SPDX-License-Identifier: Apache-2.0

# Makes the Debian packages twice, compares them byte by byte, asks Debian's tools what they think of them, unpacks
# them into an empty folder and runs the programs from there.
# In: BUILD_DIR, WORK_DIR, VERSION, CPACK
foreach(tool dpkg-deb dpkg-shlibdeps file lintian appstreamcli desktop-file-validate)
  find_program(${tool}_path ${tool})
  if(NOT ${tool}_path)
    message(STATUS "SKIP: no ${tool}; packaging/install_dependencies.sh check installs it")
    return()
  endif()
endforeach()

function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE ${WORK_DIR})
file(MAKE_DIRECTORY ${WORK_DIR})
foreach(round first second)
  run(${CPACK} --config ${BUILD_DIR}/CPackConfig.cmake -G DEB -B ${WORK_DIR}/${round})
endforeach()
file(GLOB packages RELATIVE ${WORK_DIR}/first ${WORK_DIR}/first/*.deb)
if(NOT packages)
  message(FATAL_ERROR "cpack made no package")
endif()

foreach(package ${packages})
  file(SHA256 ${WORK_DIR}/first/${package} first)
  file(SHA256 ${WORK_DIR}/second/${package} second)
  if(NOT first STREQUAL second)
    message(SEND_ERROR "${package} differs between two runs")
  endif()
  # CPack writes maintainer scripts that call ldconfig; the trigger beside them is what Debian wants and does no harm.
  run(lintian --allow-root --fail-on error,warning --suppress-tags maintscript-calls-ldconfig
      ${WORK_DIR}/first/${package})
  run(dpkg-deb -x ${WORK_DIR}/first/${package} ${WORK_DIR}/root)
endforeach()

set(id org.cad2slam.cad2slam)
if(EXISTS ${WORK_DIR}/root/usr/bin/cad2slam)
  run(desktop-file-validate ${WORK_DIR}/root/usr/share/applications/${id}.desktop)
  run(appstreamcli validate --no-net ${WORK_DIR}/root/usr/share/metainfo/${id}.metainfo.xml)
  if(NOT EXISTS ${WORK_DIR}/root/usr/share/icons/hicolor/scalable/apps/${id}.svg)
    message(SEND_ERROR "the desktop entry's icon is not in the package")
  endif()
endif()
foreach(program cad2slam cad2slam-cli)
  set(path ${WORK_DIR}/root/usr/bin/${program})
  if(EXISTS ${path})
    execute_process(COMMAND ${CMAKE_COMMAND} -E env QT_QPA_PLATFORM=offscreen ${path} --version
      OUTPUT_VARIABLE output COMMAND_ERROR_IS_FATAL ANY)
    string(FIND "${output}" "${VERSION}" place)
    if(place EQUAL -1)
      message(SEND_ERROR "${program} --version says '${output}', the project is ${VERSION}")
    endif()
  endif()
endforeach()
