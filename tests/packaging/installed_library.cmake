# SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
# SPDX-License-Identifier: Apache-2.0

# Installs the library for robots into an empty folder and builds and runs a robot's project against it.
# In: BUILD_DIR, CONFIG, SOURCE_DIR, WORK_DIR, GENERATOR, COMPILER, PROJECTOR (a file to read)
function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE ${WORK_DIR})
foreach(component dev lib)
  run(${CMAKE_COMMAND} --install ${BUILD_DIR} --config ${CONFIG} --component ${component} --prefix ${WORK_DIR}/prefix)
endforeach()
# Nothing of this tree may be needed any more.
run(${CMAKE_COMMAND} -S ${SOURCE_DIR}/robot -B ${WORK_DIR}/build -G ${GENERATOR} -DCMAKE_BUILD_TYPE=${CONFIG}
    -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_PREFIX_PATH=${WORK_DIR}/prefix)
run(${CMAKE_COMMAND} --build ${WORK_DIR}/build)
run(${WORK_DIR}/build/robot ${PROJECTOR})
run(${WORK_DIR}/build/robot_in_c ${PROJECTOR})
# A component that does not exist is named.
file(WRITE ${WORK_DIR}/nonsense/CMakeLists.txt
  "cmake_minimum_required(VERSION 3.25)\nproject(nonsense LANGUAGES CXX)\n"
  "find_package(cad2slam REQUIRED COMPONENTS projector nonsense)\n")
execute_process(COMMAND ${CMAKE_COMMAND} -S ${WORK_DIR}/nonsense -B ${WORK_DIR}/nonsense/build -G ${GENERATOR}
    -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_PREFIX_PATH=${WORK_DIR}/prefix
  RESULT_VARIABLE failed ERROR_VARIABLE message OUTPUT_QUIET)
if(NOT failed OR NOT message MATCHES "there is no component nonsense")
  message(FATAL_ERROR "find_package() took or did not name an unknown component: ${message}")
endif()
file(GLOB_RECURSE configs ${WORK_DIR}/prefix/*.cmake)
foreach(config ${configs})
  file(READ ${config} text)
  string(FIND "${text}" "${BUILD_DIR}" place)
  if(NOT place EQUAL -1)
    message(FATAL_ERROR "${config} names the build folder")
  endif()
endforeach()
