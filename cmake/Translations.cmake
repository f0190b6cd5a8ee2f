# SPDX-License-Identifier: Apache-2.0
# The languages of the pages: resources/translations/touchphoto_LANGUAGE.ts, compiled into the program.
set(TOUCHPHOTO_LANGUAGES en de ko)

find_package(Qt6 REQUIRED COMPONENTS LinguistTools)

# tp_translations(target): the catalogues as resources below :/translations.
function(tp_translations target)
  set(catalogues)
  foreach(language IN LISTS TOUCHPHOTO_LANGUAGES)
    list(APPEND catalogues ${PROJECT_SOURCE_DIR}/resources/translations/touchphoto_${language}.ts)
  endforeach()
  qt_add_lrelease(${target} TS_FILES ${catalogues} QM_FILES_OUTPUT_VARIABLE compiled OPTIONS -silent)
  qt_add_resources(${target} translations PREFIX /translations BASE ${CMAKE_CURRENT_BINARY_DIR} FILES ${compiled})
endfunction()
