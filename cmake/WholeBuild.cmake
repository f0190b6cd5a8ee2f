# SPDX-License-Identifier: Apache-2.0
# Building everything at once, as the scripts in packaging do, in less time. A room is compiled a dozen files at a
# time, so that the headers of Qt and OpenCV are read once for them all; a test, which is a program of its own, takes
# Qt's headers precompiled (<QTest> alone costs a compiler three seconds). What a file forgot to include then comes from
# its neighbours, which tests/house/check_own_includes.py finds; and a name in an anonymous namespace must be the only one
# of its kind in the room. After a change of one file the preset `dev`, which builds file by file, is the quicker one.
option(TOUCHPHOTO_WHOLE_BUILD "Build quickly as a whole rather than after each change" OFF)

# tp_build_as_one(room)
function(tp_build_as_one room)
  if(TOUCHPHOTO_WHOLE_BUILD)
    set_target_properties(${room} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 12)
  endif()
endfunction()

# tp_build_generated_as_one(room sources...): the same for what Qt makes of the room's QML, which has compile options of its
# own and is therefore left out above. Each file keeps to its own namespace.
function(tp_build_generated_as_one room)
  if(NOT TOUCHPHOTO_WHOLE_BUILD)
    return()
  endif()
  set(batch 0)
  while(ARGN)
    list(SUBLIST ARGN 0 12 some)
    list(REMOVE_ITEM ARGN ${some})
    list(TRANSFORM some REPLACE "(.+)" "#include \"\\1\"\n" OUTPUT_VARIABLE includes)
    list(JOIN includes "" content)
    set(file ${CMAKE_CURRENT_BINARY_DIR}/${room}_qml_${batch}.cpp)
    file(CONFIGURE OUTPUT ${file} CONTENT "${content}" @ONLY)
    set_source_files_properties(${some} PROPERTIES HEADER_FILE_ONLY ON)
    set_source_files_properties(${file} PROPERTIES COMPILE_OPTIONS -w OBJECT_DEPENDS "${some}" SKIP_AUTOGEN ON)
    target_sources(${room} PRIVATE ${file})
    math(EXPR batch "${batch} + 1")
  endwhile()
endfunction()

# Only headers that mean the same everywhere: not <QTest> itself and nothing of Qt Gui, which look at macros that
# differ from one target to the next.
set(_precompiled <QDateTime> <QDir> <QFile> <QJsonDocument> <QObject> <QTemporaryDir> <QThread> <QVariant>
    <algorithm> <atomic> <cmath> <filesystem> <fstream> <functional> <random> <set> <thread> <opencv2/imgproc.hpp>)

# What a test itself does is little; to optimize two hundred of them would cost more than all rooms together. The rooms
# that it tests are those that people run.
if(TOUCHPHOTO_WHOLE_BUILD)
  set(_test_effort -Og)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    list(APPEND _test_effort -Wno-maybe-uninitialized) # needs more effort than this not to be led astray
  endif()
  if(TOUCHPHOTO_SANITIZE AND CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
    set(_test_effort -O0 -fno-sanitize=fuzzer-no-link) # the fuzzers look into the rooms, not into the tests
  endif()
  if(CMAKE_SYSTEM_PROCESSOR STREQUAL "aarch64")
    list(APPEND _test_effort -fPIC) # as what is precompiled; elsewhere Qt asks for it
  endif()
  file(CONFIGURE OUTPUT precompiled.cpp CONTENT "")
  add_library(tp_precompiled OBJECT ${PROJECT_BINARY_DIR}/precompiled.cpp)
  target_link_libraries(tp_precompiled PRIVATE Qt6::Core opencv_imgproc tp_compile_options) # -Wpedantic changes macros
  target_precompile_headers(tp_precompiled PRIVATE ${_precompiled})
  target_compile_options(tp_precompiled PRIVATE ${_test_effort})
endif()

# What Clang precompiles tells where the clone lies and when its files were written. For a compiler's cache to know a test in
# another clone, tests name it from the build's folder, and the cache is told what it is made of (CCACHE_PCH_EXTSUM).
if(TOUCHPHOTO_WHOLE_BUILD AND CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
  set(_precompiled_by_clang CMakeFiles/tp_precompiled.dir/cmake_pch.hxx.pch)
  set(_made_of ${PROJECT_BINARY_DIR}/${_precompiled_by_clang}.sum)
  add_custom_command(OUTPUT ${_made_of} DEPENDS tp_precompiled ${PROJECT_BINARY_DIR}/${_precompiled_by_clang}
    COMMAND ${CMAKE_CXX_COMPILER} -std=c++20 -fPIC -E -dD -P
      "-isystem$<JOIN:$<TARGET_PROPERTY:tp_precompiled,INCLUDE_DIRECTORIES>,;-isystem>"
      -o precompiled.txt ${PROJECT_BINARY_DIR}/CMakeFiles/tp_precompiled.dir/cmake_pch.hxx
    COMMAND ${CMAKE_COMMAND} -E sha256sum precompiled.txt > ${_made_of}
    WORKING_DIRECTORY ${PROJECT_BINARY_DIR} COMMAND_EXPAND_LISTS VERBATIM)
  add_custom_target(tp_precompiled_sum DEPENDS ${_made_of})
endif()

# tp_compile_quickly(test)
# Not for a test that itself computes much: what of its code the rooms use too would be as slow there, because one copy
# of a function serves the whole program.
function(tp_compile_quickly test)
  if(TOUCHPHOTO_WHOLE_BUILD)
    target_compile_options(${test} PRIVATE ${_test_effort})
    if(_precompiled_by_clang)
      target_compile_options(${test} PRIVATE "SHELL:-Xclang -include-pch -Xclang ${_precompiled_by_clang}")
      add_dependencies(${test} tp_precompiled_sum)
    else()
      target_precompile_headers(${test} REUSE_FROM tp_precompiled)
    endif()
  endif()
endfunction()
