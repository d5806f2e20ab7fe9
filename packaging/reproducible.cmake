# SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
# SPDX-License-Identifier: Apache-2.0

# Sets SOURCE_DATE_EPOCH to the time of the commit in `source_dir`, unless the caller has set it. With it the archives
# carry that time instead of now, so that two builds of one commit give the same bytes.
function(cad2slam_set_source_date_epoch source_dir)
  if(DEFINED ENV{SOURCE_DATE_EPOCH})
    return()
  endif()
  execute_process(COMMAND git -C ${source_dir} log -1 --format=%ct
    OUTPUT_VARIABLE epoch OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  if(epoch MATCHES "^[0-9]+$")
    set(ENV{SOURCE_DATE_EPOCH} ${epoch})
  endif()
endfunction()

if(DEFINED CPACK_CAD2SLAM_SOURCE_DIR)
  cad2slam_set_source_date_epoch("${CPACK_CAD2SLAM_SOURCE_DIR}")
endif()
