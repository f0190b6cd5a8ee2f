# SPDX-License-Identifier: Apache-2.0
# tp_read_tests(words of tp_tests...): sets `target`, `names`, `stems` (FILE_test), and arg_SHARED, arg_DEPENDS, arg_THREADED and
# arg_COMPUTES where tp_tests is.
macro(tp_read_tests prefix)
  cmake_parse_arguments(arg "THREADED;COMPUTES" "" "TESTS;SHARED;DEPENDS" ${ARGN})
  cmake_path(RELATIVE_PATH CMAKE_CURRENT_SOURCE_DIR BASE_DIRECTORY ${PROJECT_SOURCE_DIR}/tests OUTPUT_VARIABLE target)
  string(REPLACE "/" "_" target "test_${target}")
  if(arg_THREADED)
    string(APPEND target _threads)
  elseif(arg_COMPUTES)
    string(APPEND target _computes)
  endif()
  set(names ${arg_TESTS})
  set(stems ${arg_TESTS})
  list(TRANSFORM names REPLACE "=.*" "")
  list(TRANSFORM stems REPLACE ".*=" "")
  list(TRANSFORM stems APPEND _test)
endmacro()

# tp_build_tests_as_one(target): a dozen at a time where everything is built. To GCC a file that another one includes is a header,
# of which it asks that no class uses what is anonymous there.
function(tp_build_tests_as_one target)
  tp_build_as_one(${target})
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
endfunction()
