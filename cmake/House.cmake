# SPDX-License-Identifier: Apache-2.0
# The arrows of the house, enforced by the build.
#
# Each room is a library. Its headers are staged in an include root of its own and reach only the
# targets that depend on it, under their full path in the house (`#include "core/geometry/contour.hpp"`),
# so including a room that is not a declared dependency fails to compile. Declaring a dependency that the
# table below does not allow fails to configure.

# Who may include whom: tp_may(room  rooms-it-may-depend-on... USES outside-libraries...)
function(tp_may room)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "USES")
  set_property(GLOBAL PROPERTY TP_MAY_${room} "${arg_UNPARSED_ARGUMENTS}")
  set_property(GLOBAL PROPERTY TP_USES_${room} "${arg_USES}")
endfunction()

set(_core tp_base tp_files tp_geometry tp_guidance tp_servo tp_svg tp_study)
set(_below_app ${_core} tp_device tp_faces tp_speech tp_sentences tp_recordings tp_sound)
tp_may(tp_base)
tp_may(tp_files tp_base)
tp_may(tp_geometry tp_base                          USES glm::glm)
tp_may(tp_guidance tp_base tp_geometry)
tp_may(tp_svg      tp_base tp_files tp_geometry tp_guidance  USES PkgConfig::pugixml PkgConfig::2geom)
tp_may(tp_servo    tp_base tp_geometry tp_guidance  USES Threads::Threads)
tp_may(tp_study    tp_base tp_geometry tp_guidance tp_servo)
tp_may(tp_device   ${_core} tp_pad_protocol tp_pad_firmware tp_haply_protocol USES PkgConfig::hidapi PkgConfig::libusb Threads::Threads)
tp_may(tp_pad_protocol) # nothing at all: it runs on a microcontroller
tp_may(tp_pad_firmware tp_pad_protocol)
tp_may(tp_haply_protocol)
tp_may(tp_force_guard tp_haply_protocol) # a small process that starts at once
tp_may(tp_exiv2                                     USES PkgConfig::exiv2)
tp_may(tp_faces    ${_core} tp_exiv2                USES PkgConfig::exiv2 PkgConfig::turbojpeg opencv_core opencv_imgproc
                                                         opencv_dnn opencv_objdetect opencv_face Threads::Threads)
tp_may(tp_evaluation tp_base tp_geometry tp_guidance tp_faces  USES opencv_core opencv_imgproc PkgConfig::turbojpeg)
tp_may(tp_speech   tp_base                          USES Qt6::Core Qt6::TextToSpeech)
tp_may(tp_recordings tp_base tp_files               USES PkgConfig::sndfile PkgConfig::ebur128)
tp_may(tp_video    tp_base tp_files tp_recordings)
tp_may(tp_sentences                                 USES Qt6::Core)
tp_may(tp_sound    tp_base tp_files tp_sentences tp_recordings USES Qt6::Core Qt6::Multimedia PkgConfig::soundtouch)
tp_may(tp_guide    tp_base tp_sound                 USES Qt6::Core)
tp_may(tp_metadata tp_base tp_files tp_recordings tp_exiv2 USES PkgConfig::exiv2 PkgConfig::pugixml)
tp_may(tp_index    tp_base tp_files tp_recordings tp_metadata USES Qt6::Core Qt6::Sql)
tp_may(tp_keeper   tp_base tp_files tp_recordings tp_video tp_metadata tp_index USES Qt6::Core PkgConfig::archive)
tp_may(tp_scene    tp_base tp_files tp_geometry tp_guidance tp_svg tp_faces)
tp_may(tp_people  tp_base tp_geometry tp_faces tp_metadata)
tp_may(tp_picture  ${_below_app}                    USES Qt6::Gui)
tp_may(tp_report   ${_below_app}                    USES Qt6::Gui Qt6::Svg)
tp_may(tp_bench    tp_base tp_geometry tp_guidance tp_faces tp_evaluation tp_report  USES Boost::headers nanoflann::nanoflann)
tp_may(tp_tactile  ${_below_app} tp_scene  USES Qt6::Gui PkgConfig::pugixml PkgConfig::louis)
tp_may(tp_controls ${_below_app}                    USES Qt6::Quick Qt6::QuickControls2 Qt6::DBus)
tp_may(tp_narration tp_base tp_speech tp_controls   USES Qt6::Core)
tp_may(tp_preferences tp_base tp_files tp_sentences USES Qt6::Core)
tp_may(tp_open_album tp_base tp_files tp_sentences tp_recordings tp_metadata tp_index tp_keeper tp_preferences USES Qt6::Core)
tp_may(tp_devices  tp_base tp_files tp_geometry tp_servo tp_device tp_sentences  USES Qt6::Core)
set(_below_page ${_below_app} tp_devices tp_guide tp_metadata tp_index tp_keeper tp_open_album tp_people tp_scene tp_picture tp_controls tp_narration tp_preferences tp_tactile tp_folders)
tp_may(tp_folders  ${_below_app} tp_controls tp_narration USES Qt6::Quick)
tp_may(tp_explore  ${_below_page}                   USES Qt6::Quick)
tp_may(tp_settings ${_below_page}                   USES Qt6::Quick)
tp_may(tp_lab      ${_below_page}                   USES Qt6::Quick)
tp_may(tp_start    ${_below_page}                   USES Qt6::Quick)
tp_may(tp_browse   ${_below_page}                   USES Qt6::Quick)
tp_may(tp_care     ${_below_page}                   USES Qt6::Quick)
tp_may(tp_mend     ${_below_page} tp_report         USES Qt6::Quick)
tp_may(tp_print    ${_below_page}                   USES Qt6::Quick Qt6::Svg)
tp_may(tp_shell    ${_below_page} tp_browse tp_care tp_explore tp_lab tp_mend tp_print tp_settings tp_start USES Qt6::Quick)
tp_may(tp_cli      ${_below_app} tp_devices tp_evaluation tp_metadata tp_people tp_index tp_keeper tp_scene tp_picture tp_report tp_tactile tp_bench         USES Qt6::Core Qt6::Gui Qt6::Network)

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

# tp_room(name SOURCES ... DEPENDS rooms... USES outside-libraries...): one room of the house as a static library.
# Everything is linked publicly: a header may show what its room may use.
function(tp_room name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;DEPENDS;USES")
  tp_check_arrows(${name} DEPENDS ${arg_DEPENDS} USES ${arg_USES})
  if(NOT TARGET ${name})
    add_library(${name} STATIC)
  endif()
  if("${arg_USES}" MATCHES "Qt6::")
    set_target_properties(${name} PROPERTIES AUTOMOC ON)
  endif()
  tp_build_as_one(${name})
  target_sources(${name} PRIVATE ${arg_SOURCES})
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
