# SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
# SPDX-License-Identifier: Apache-2.0

# Makes the Debian packages twice, compares them byte by byte, asks Debian's tools what they think of them, unpacks
# them into an empty folder and runs everything from there.
# In: SOURCE_DIR, BUILD_DIR, WORK_DIR, VERSION, CPACK
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

list(TRANSFORM packages PREPEND ${WORK_DIR}/first/ OUTPUT_VARIABLE paths)
foreach(package ${packages})
  file(SHA256 ${WORK_DIR}/first/${package} first)
  file(SHA256 ${WORK_DIR}/second/${package} second)
  if(NOT first STREQUAL second)
    message(SEND_ERROR "${package} differs between two runs")
  endif()
  run(dpkg-deb -x ${WORK_DIR}/first/${package} ${WORK_DIR}/root)
endforeach()
# CPack writes maintainer scripts that call ldconfig; the trigger beside them is what Debian wants and does no harm.
run(lintian --allow-root --fail-on error,warning --suppress-tags maintscript-calls-ldconfig ${paths})

# Where something was built must not change what is packaged (packaging/reproduce.sh builds twice).
execute_process(COMMAND grep -rlF -e ${SOURCE_DIR} -e ${BUILD_DIR} ${WORK_DIR}/root OUTPUT_VARIABLE with_path)
if(with_path)
  message(SEND_ERROR "these files name the folder they were built in:\n${with_path}")
endif()

set(id org.cad2slam.cad2slam)
if(EXISTS ${WORK_DIR}/root/usr/bin/cad2slam)
  run(desktop-file-validate ${WORK_DIR}/root/usr/share/applications/${id}.desktop)
  run(appstreamcli validate --no-net ${WORK_DIR}/root/usr/share/metainfo/${id}.metainfo.xml)
  if(NOT EXISTS ${WORK_DIR}/root/usr/share/icons/hicolor/scalable/apps/${id}.svg)
    message(SEND_ERROR "the desktop entry's icon is not in the package")
  endif()
endif()
find_program(mime_path update-mime-database)
if(mime_path AND EXISTS ${WORK_DIR}/root/usr/share/mime)
  run(${mime_path} ${WORK_DIR}/root/usr/share/mime)
  file(READ ${WORK_DIR}/root/usr/share/mime/globs2 globs)
  foreach(glob "x-cad2slam-project:*.c2sproj" "x-cad2slam-projector:*.c2s")
    string(FIND "${globs}" "application/${glob}\n" place)
    if(place EQUAL -1)
      message(SEND_ERROR "the MIME database lacks ${glob}: ${globs}")
    endif()
  endforeach()
endif()

foreach(document projector-file.md example.c2s guide-nav2.md guide-open-rmf.md guide-vda5050.md)
  if(NOT EXISTS ${WORK_DIR}/root/usr/share/doc/libcad2slam-dev/${document})
    message(SEND_ERROR "${document} is not in the package for developers")
  endif()
endforeach()

# Programs, library and module as a robot has them, with nothing from the tree but a file to read.
file(GLOB_RECURSE library ${WORK_DIR}/root/usr/lib/libcad2slam.so.0)
cmake_path(GET library PARENT_PATH library_folder)
set(from_root ${CMAKE_COMMAND} -E env QT_QPA_PLATFORM=offscreen LD_LIBRARY_PATH=${library_folder}
    PYTHONPATH=${WORK_DIR}/root/usr/lib/python3/dist-packages)
function(expect words)
  execute_process(COMMAND ${from_root} ${ARGN} WORKING_DIRECTORY ${WORK_DIR}/root OUTPUT_VARIABLE output
    COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
  string(FIND "${output}" "${words}" place)
  if(place EQUAL -1)
    message(SEND_ERROR "${ARGN} says '${output}', not '${words}'")
  endif()
endfunction()
configure_file(${SOURCE_DIR}/docs/example.c2s ${WORK_DIR}/root/example.c2s COPYONLY)
foreach(program cad2slam cad2slam-cli)
  if(EXISTS ${WORK_DIR}/root/usr/bin/${program})
    expect(${VERSION} ${WORK_DIR}/root/usr/bin/${program} --version)
  endif()
endforeach()
if(EXISTS ${WORK_DIR}/root/usr/bin/cad2slam-cli)
  expect("2 poses, all reproduced" ${WORK_DIR}/root/usr/bin/cad2slam-cli info example.c2s)
endif()
foreach(native True False)
  expect("inside" /usr/bin/python3 -B -c "import cad2slam
pose = cad2slam.load('example.c2s', native=${native}).slam_from_blueprint([0.75, 0.25, 0.0])
print(cad2slam.Status(int(pose.status)).name.lower())")
endforeach()
