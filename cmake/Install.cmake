# SPDX-License-Identifier: Apache-2.0
# What is installed, and where. Two parts, each of which works without the other: touchphoto, the program with pages, and
# touchphoto-lab, for a shell and without Qt Quick. `cmake --install build/release --prefix /usr` installs both, with
# `--component touchphoto` or `--component touchphoto-lab` one of them.
# Pages, translations, nets, sounds and the sample portrait are inside the programs.
include(GNUInstallDirs)
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON) # what is built is installed: nobody waits for tests
set(installed_name org.touchphoto.TouchPhoto)
set(shipped ${PROJECT_SOURCE_DIR}/resources)

# tp_install_program(program): with the helpers that it finds there (helper_program), the rules that let a person use a
# force device, what a shell completes, and the manual.
function(tp_install_program program)
  install(TARGETS ${program} RUNTIME COMPONENT ${program})
  install(TARGETS touchphoto-decoder touchphoto-force-guard
    RUNTIME DESTINATION ${CMAKE_INSTALL_LIBEXECDIR}/${program} COMPONENT ${program})
  install(FILES ${shipped}/udev/70-touchphoto.rules RENAME 70-${program}.rules
    DESTINATION lib/udev/rules.d COMPONENT ${program})
  install(FILES ${shipped}/completion/${program}
    DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT ${program})
endfunction()
tp_install_program(touchphoto)
tp_install_program(touchphoto-lab)

install(FILES ${shipped}/desktop/${installed_name}.desktop
  DESTINATION ${CMAKE_INSTALL_DATADIR}/applications COMPONENT touchphoto)
install(FILES ${shipped}/desktop/${installed_name}.metainfo.xml
  DESTINATION ${CMAKE_INSTALL_DATADIR}/metainfo COMPONENT touchphoto)
install(FILES ${shipped}/desktop/${installed_name}.mime.xml RENAME ${installed_name}.xml
  DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages COMPONENT touchphoto)
foreach(size 16 22 24 32 48 64 96 128 256 512)
  install(DIRECTORY ${shipped}/icons/hicolor/${size}x${size}/
    DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/${size}x${size}/apps COMPONENT touchphoto)
endforeach()
install(FILES ${shipped}/icons/${installed_name}.svg
  DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps COMPONENT touchphoto)
install(DIRECTORY ${shipped}/studies
  DESTINATION ${CMAKE_INSTALL_DATADIR}/touchphoto-lab COMPONENT touchphoto-lab FILES_MATCHING PATTERN *.study)
