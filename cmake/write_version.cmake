# SPDX-License-Identifier: Apache-2.0
# cmake -DOUT=FILE -P write_version.cmake: writes the program's number, which stands in the root's CMakeLists.txt and
# nowhere else, and the commit that is built, for core/version. Touches the file only where it changes. What is built from
# an exported tree has the commit that `git archive` wrote into commit.txt; what is neither has none.
cmake_path(GET CMAKE_CURRENT_LIST_DIR PARENT_PATH root)
file(STRINGS ${root}/CMakeLists.txt line REGEX "^project\\(TouchPhoto VERSION ")
string(REGEX MATCH "[0-9]+\\.[0-9]+\\.[0-9]+" number "${line}")
if(NOT number)
  message(FATAL_ERROR "${root}/CMakeLists.txt says no version: it should begin a line with project(TouchPhoto VERSION 1.2.3")
endif()

file(STRINGS ${root}/cmake/commit.txt commit REGEX "^[0-9a-f]+$")
if(NOT commit AND EXISTS ${root}/.git)
  execute_process(COMMAND git rev-parse HEAD WORKING_DIRECTORY ${root}
    OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE RESULT_VARIABLE problem ERROR_QUIET)
  if(problem)
    set(commit)
  endif()
endif()
string(SUBSTRING "${commit}" 0 12 commit)

set(text "// Written by cmake/write_version.cmake.\n#define TOUCHPHOTO_VERSION \"${number}\"\n#define TOUCHPHOTO_COMMIT \"${commit}\"\n")
if(EXISTS ${OUT})
  file(READ ${OUT} before)
endif()
if(NOT before STREQUAL text)
  file(WRITE ${OUT} "${text}")
endif()
