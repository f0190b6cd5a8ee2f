# SPDX-License-Identifier: Apache-2.0
# Qt's and OpenCV's headers, read once for every room and test that uses Qt: <QTest> alone costs a compiler three
# seconds. A precompiled header also gives a file what it forgot to include; therefore only the sanitizers' presets take
# it, and the others find the forgotten include.
option(TOUCHPHOTO_PRECOMPILE "Precompile the headers of Qt and OpenCV; needs GCC" OFF)

# Only headers that mean the same everywhere: not <QTest> itself and nothing of Qt Gui, which look at macros that
# differ from one target to the next.
set(_precompiled <QDateTime> <QDir> <QFile> <QJsonDocument> <QObject> <QTemporaryDir> <QThread> <QVariant>
    <algorithm> <atomic> <cmath> <filesystem> <fstream> <functional> <random> <set> <thread> <opencv2/imgproc.hpp>)

if(TOUCHPHOTO_PRECOMPILE)
  file(CONFIGURE OUTPUT precompiled.cpp CONTENT "")
  add_library(tp_precompiled OBJECT ${PROJECT_BINARY_DIR}/precompiled.cpp)
  target_link_libraries(tp_precompiled PRIVATE Qt6::Core opencv_imgproc tp_compile_options) # -Wpedantic changes macros
  target_precompile_headers(tp_precompiled PRIVATE ${_precompiled})
endif()

# tp_use_precompiled(target): the target, which links Qt, takes the precompiled headers.
function(tp_use_precompiled target)
  if(TOUCHPHOTO_PRECOMPILE)
    target_precompile_headers(${target} REUSE_FROM tp_precompiled)
  endif()
endfunction()
