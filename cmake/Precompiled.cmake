# SPDX-License-Identifier: Apache-2.0
# Qt's and OpenCV's headers, read once for every room and test that uses Qt: <QTest> alone costs a compiler three
# seconds. A precompiled header also gives a file what it forgot to include; therefore only the sanitizers' presets take
# it everywhere, packaging/test takes it for the tests of the release build, and the rooms of that build find the
# forgotten include. Needs GCC.
set(TOUCHPHOTO_PRECOMPILE OFF CACHE STRING "Who takes precompiled headers: OFF, TESTS or ON (rooms and tests)")

# Only headers that mean the same everywhere: not <QTest> itself and nothing of Qt Gui, which look at macros that
# differ from one target to the next.
set(_precompiled <QDateTime> <QDir> <QFile> <QJsonDocument> <QObject> <QTemporaryDir> <QThread> <QVariant>
    <algorithm> <atomic> <cmath> <filesystem> <fstream> <functional> <random> <set> <thread> <opencv2/imgproc.hpp>)

if(NOT TOUCHPHOTO_PRECOMPILE STREQUAL "OFF")
  file(CONFIGURE OUTPUT precompiled.cpp CONTENT "")
  add_library(tp_precompiled OBJECT ${PROJECT_BINARY_DIR}/precompiled.cpp)
  target_link_libraries(tp_precompiled PRIVATE Qt6::Core opencv_imgproc tp_compile_options) # -Wpedantic changes macros
  target_precompile_headers(tp_precompiled PRIVATE ${_precompiled})
endif()

# tp_use_precompiled(target): the target, which links Qt, takes the precompiled headers; with TEST as a test does.
function(tp_use_precompiled target)
  cmake_parse_arguments(PARSE_ARGV 1 arg "TEST" "" "")
  if(TOUCHPHOTO_PRECOMPILE STREQUAL "ON" OR (TOUCHPHOTO_PRECOMPILE STREQUAL "TESTS" AND arg_TEST))
    target_precompile_headers(${target} REUSE_FROM tp_precompiled)
  endif()
endfunction()
