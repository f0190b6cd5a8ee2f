# SPDX-License-Identifier: Apache-2.0
# How a room is built. Each room is a library. Its headers are staged in an include root of its own and reach only the
# targets that depend on it, under their full path in the house (`#include "core/geometry/contour.hpp"`), so including a
# room that is not a declared dependency fails to compile. Declaring a dependency that the table in House.cmake does not
# allow fails to configure.

# tp_may(room  rooms-it-may-depend-on... USES outside-libraries...): a line of that table.
function(tp_may room)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "USES")
  set_property(GLOBAL PROPERTY TP_MAY_${room} "${arg_UNPARSED_ARGUMENTS}")
  set_property(GLOBAL PROPERTY TP_USES_${room} "${arg_USES}")
endfunction()

# tp_check_arrows(room DEPENDS rooms... USES libraries...): stops the configuration on a forbidden arrow.
function(tp_check_arrows room)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "DEPENDS;USES")
  get_property(known GLOBAL PROPERTY TP_MAY_${room} SET)
  if(NOT known)
    message(FATAL_ERROR "${room} has no line in the table in cmake/House.cmake")
  endif()
  get_property(may GLOBAL PROPERTY TP_MAY_${room})
  get_property(uses GLOBAL PROPERTY TP_USES_${room})
  foreach(other IN LISTS arg_DEPENDS)
    if(NOT other IN_LIST may)
      message(FATAL_ERROR "${room} may not include ${other}: see the table in cmake/House.cmake")
    endif()
  endforeach()
  foreach(library IN LISTS arg_USES)
    if(NOT library IN_LIST uses)
      message(FATAL_ERROR "${room} may not use ${library}: see the table in cmake/House.cmake")
    endif()
  endforeach()
endfunction()

# tp_stage_headers(room folder): makes `folder` (relative to the root) visible below the room's own include root.
function(tp_stage_headers room folder)
  set(root ${PROJECT_BINARY_DIR}/house/${room})
  cmake_path(GET folder PARENT_PATH parent)
  file(MAKE_DIRECTORY ${root}/${parent})
  if(NOT EXISTS ${root}/${folder})
    file(CREATE_LINK ${PROJECT_SOURCE_DIR}/${folder} ${root}/${folder} SYMBOLIC)
  endif()
  get_target_property(type ${room} TYPE)
  if(type STREQUAL "INTERFACE_LIBRARY")
    target_include_directories(${room} INTERFACE ${root})
  else()
    target_include_directories(${room} PUBLIC ${root})
  endif()
endfunction()

# tp_of_system(variable names...): the file that each name has on this system, such as NAME_linux.cpp or, where there is none,
# NAME_posix.cpp. tests/house/systems.py keeps a system's own headers in such files.
function(tp_of_system variable)
  if(WIN32)
    set(endings windows elsewhere)
  elseif(APPLE)
    set(endings macos posix elsewhere)
  else()
    set(endings linux posix elsewhere)
  endif()
  set(files)
  foreach(name IN LISTS ARGN)
    set(found)
    foreach(ending IN LISTS endings)
      if(NOT found AND EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/${name}_${ending}.cpp)
        set(found ${name}_${ending}.cpp)
      endif()
    endforeach()
    if(NOT found)
      message(FATAL_ERROR "${CMAKE_CURRENT_SOURCE_DIR} has no ${name} for this system: write ${name}_*.cpp with one of: ${endings}")
    endif()
    list(APPEND files ${found})
  endforeach()
  set(${variable} ${files} PARENT_SCOPE)
endfunction()

# tp_room(name SOURCES ... OF_SYSTEM names... DEPENDS rooms... USES outside-libraries...): one room of the house as a static
# library. Everything is linked publicly: a header may show what its room may use.
function(tp_room name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;OF_SYSTEM;DEPENDS;USES")
  tp_of_system(of_system ${arg_OF_SYSTEM})
  tp_check_arrows(${name} DEPENDS ${arg_DEPENDS} USES ${arg_USES})
  if(NOT TARGET ${name})
    add_library(${name} STATIC)
  endif()
  if("${arg_USES}" MATCHES "Qt6::")
    set_target_properties(${name} PROPERTIES AUTOMOC ON)
  endif()
  tp_build_as_one(${name})
  if(WIN32)
    set_source_files_properties(${of_system} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON) # windows.h makes macros of "near" and "far"
  endif()
  target_sources(${name} PRIVATE ${arg_SOURCES} ${of_system})
  target_link_libraries(${name} PUBLIC ${arg_DEPENDS} ${arg_USES} PRIVATE tp_compile_options)
  file(RELATIVE_PATH folder ${PROJECT_SOURCE_DIR} ${CMAKE_CURRENT_SOURCE_DIR})
  tp_stage_headers(${name} ${folder})
endfunction()

# tp_qml_module(room URI uri FILES qml-files... SINGLETONS qml-files...): the room's QML, imported as `uri`, in resources. A
# program that uses it calls the room's register function, because a static library's own registration is left out
# by the linker. What Qt generates is not judged by our warnings.
function(tp_qml_module room)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "URI" "FILES;SINGLETONS")
  set_source_files_properties(${arg_SINGLETONS} PROPERTIES QT_QML_SINGLETON_TYPE TRUE)
  string(REPLACE "." "/" path ${arg_URI})
  set(QT_QML_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/qml)
  set(compiled)
  if(TOUCHPHOTO_SANITIZE)
    set(compiled NO_CACHEGEN) # QML that is compiled ahead starts sooner and is no code of ours for a sanitizer
  endif()
  qt_add_qml_module(${room} URI ${arg_URI} VERSION 1.0 NO_PLUGIN
    RESOURCE_PREFIX /qt-project.org/imports OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/qml/${path}
    IMPORT_PATH ${PROJECT_BINARY_DIR}/qml DEPENDENCIES QtQuick ${compiled}
    QML_FILES ${arg_FILES} ${arg_SINGLETONS})
  target_include_directories(${room} PRIVATE ${CMAKE_CURRENT_SOURCE_DIR}) # for the generated registration
  get_target_property(sources ${room} SOURCES)
  list(FILTER sources INCLUDE REGEX "^${PROJECT_BINARY_DIR}.*\\.cpp$")
  set_source_files_properties(${sources} PROPERTIES COMPILE_OPTIONS -w)
  list(FILTER sources INCLUDE REGEX "/qmlcache/.*_qml\\.cpp$")
  tp_build_generated_as_one(${room} ${sources})
endfunction()
