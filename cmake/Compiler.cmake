# SPDX-License-Identifier: Apache-2.0
# Language level, warnings and sanitizers for our own code. The target `tp_compile_options`
# carries them, so that foreign code (Qt's generated sources) is not judged by our warnings.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

option(TOUCHPHOTO_WERROR "Treat warnings in our own code as errors" OFF)
set(TOUCHPHOTO_SANITIZE "" CACHE STRING "Sanitizers for every target, e.g. address;undefined or thread")

add_library(tp_compile_options INTERFACE)
if(MSVC) # untried: nobody has built it so yet
  target_compile_options(tp_compile_options INTERFACE /W4 /permissive- /utf-8 $<$<BOOL:${TOUCHPHOTO_WERROR}>:/WX>)
  add_compile_definitions(UNICODE NOMINMAX WIN32_LEAN_AND_MEAN _WIN32_WINNT=0x0A00)
else()
  target_compile_options(tp_compile_options INTERFACE
    -Wall -Wextra -Wpedantic -Wconversion
    # In a room that is compiled as one, a local name may be that of a neighbour file's.
    $<IF:$<BOOL:${TOUCHPHOTO_WHOLE_BUILD}>,$<$<CXX_COMPILER_ID:GNU>:-Wshadow=local>,-Wshadow>
    $<$<BOOL:${TOUCHPHOTO_WERROR}>:-Werror>)
endif()

# A processor that multiplies and adds in one step rounds once instead of twice: what is exact by its operations, such as that
# the point of a segment nearest to its end is its end, would not be there, and the same scene would be another one. Without
# an option the compilers of such processors do so; on a 64-bit PC they do not.
if(NOT MSVC AND NOT CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64)$")
  add_compile_options(-ffp-contract=off)
endif()

# GCC for Windows keeps values in registers across a call of a template's function whose body it sees, although the linker may
# take that function from another file, where it uses other registers (seen with GCC 12: the angle of a force pad's arm lost).
if(MINGW)
  add_compile_options(-fno-ipa-ra)
endif()

# Two hundred programs are linked; mold needs a fraction of the time of the usual linker. Its 1.10 of Debian 12 lets what
# is made read-only begin at the first thread_local variable, where one byte before a page's end belongs to nothing: then
# the program cannot be started. A variable that is aligned like a cache line never lies there, so each of ours is.
find_program(TOUCHPHOTO_MOLD mold)
if(TOUCHPHOTO_MOLD)
  add_link_options(-fuse-ld=mold)
endif()

if(TOUCHPHOTO_SANITIZE)
  string(REPLACE ";" "," _sanitizers "${TOUCHPHOTO_SANITIZE}")
  add_compile_options(-fsanitize=${_sanitizers} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  add_link_options(-fsanitize=${_sanitizers})
  # What a sanitizer adds to the code leads this warning astray (GCC manual, -fsanitize); the release build has it.
  target_compile_options(tp_compile_options INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
endif()
