# SPDX-License-Identifier: Apache-2.0
# What the include paths cannot forbid, because it lies in the system's own: outside libraries in core, Qt below the
# rooms that may use it, and paths that climb out of a room.
cmake_minimum_required(VERSION 3.25)
set(faults "")

# forbid(folders... PATTERN regex WHY text EXCEPT beginnings of paths)
function(forbid)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "PATTERN;WHY;EXCEPT" "")
  foreach(folder IN LISTS arg_UNPARSED_ARGUMENTS)
    file(GLOB_RECURSE sources RELATIVE ${ROOT} ${ROOT}/${folder}/*.hpp ${ROOT}/${folder}/*.cpp)
    foreach(source IN LISTS sources)
      if(arg_EXCEPT AND source MATCHES "^(${arg_EXCEPT})")
        continue()
      endif()
      file(STRINGS ${ROOT}/${source} lines REGEX "^ *# *include ${arg_PATTERN}")
      foreach(line IN LISTS lines)
        string(APPEND faults "${source}: ${line} (${arg_WHY})\n")
      endforeach()
    endforeach()
  endforeach()
  set(faults "${faults}" PARENT_SCOPE)
endfunction()

forbid(core device faces PATTERN "<Q" WHY "no Qt below audio and app")
forbid(core device PATTERN "<opencv" WHY "OpenCV belongs to faces")
forbid(core PATTERN "<(pugixml|2geom|exiv2|turbojpeg)" WHY "only core/svg has a library beside GLM" EXCEPT core/svg/)
forbid(core PATTERN "<(fstream|filesystem|iostream|cstdio)" WHY "no I/O in core outside core/files, core/processes, core/study_folder and core/svg" EXCEPT "core/(files|processes|study_folder|svg)/")
forbid(app audio PATTERN "<Q(Network|Tcp|Udp|Ssl|Local(Socket|Server)|Abstract(Socket|NetworkCache)|WebSocket)" WHY "nothing goes online, and own_resources keeps the pages from it"
       EXCEPT "app/shell/own_resources[.]cpp")
forbid(app audio PATTERN "\"faces/(detect|contours|edges|pieces|judge|training)/" WHY "other rooms ask extract")
forbid(app audio PATTERN "\"faces/(models|evaluation)/" WHY "only the shell and the figures list and measure models" EXCEPT "app/(cli|figures)/")
forbid(core device faces audio app PATTERN "\"\\.\\.?/" WHY "include by the path in the house")

if(faults)
  message(FATAL_ERROR "Includes that the house forbids:\n${faults}")
endif()
