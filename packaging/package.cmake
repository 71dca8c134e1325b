# What is installed, and how cpack makes a Debian package of it (./run package).
include(GNUInstallDirs)

set(packaging ${CMAKE_CURRENT_LIST_DIR})
set(made ${CMAKE_BINARY_DIR}/packaging)
add_custom_command(OUTPUT ${made}/mapwright.1.gz
  COMMAND ${CMAKE_COMMAND} -E make_directory ${made}
  COMMAND ${packaging}/man-page $<TARGET_FILE:mapwright> > ${made}/mapwright.1
  COMMAND gzip -9nf ${made}/mapwright.1
  DEPENDS mapwright ${packaging}/man-page VERBATIM)
add_custom_command(OUTPUT ${made}/NEWS.gz
  COMMAND ${CMAKE_COMMAND} -E make_directory ${made}
  COMMAND gzip -9nc ${CMAKE_SOURCE_DIR}/CHANGELOG.md > ${made}/NEWS.gz
  DEPENDS CHANGELOG.md VERBATIM)
add_custom_target(installed_files ALL DEPENDS mapwright ${made}/mapwright.1.gz ${made}/NEWS.gz)

# Whatever the umask is.
set(CMAKE_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS ${CMAKE_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS})

install(TARGETS mapwright RUNTIME)
install(FILES ${made}/mapwright.1.gz DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES ${packaging}/mapwright.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications)
install(FILES ${packaging}/mapwright.metainfo.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/metainfo)
install(FILES ${packaging}/mapwright.mime.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages RENAME mapwright.xml)
install(FILES ${packaging}/mapwright.bash
  DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME mapwright)
install(FILES resources/mapwright.svg DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps)
install(FILES ${packaging}/copyright ${made}/NEWS.gz DESTINATION ${CMAKE_INSTALL_DOCDIR})
# The pages of Help > Manual, as in the sources, so that their links and pictures are there.
set(manual ${CMAKE_SOURCE_DIR}/docs/manual.qrc)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${manual})
file(STRINGS ${manual} pages REGEX "<file>")
foreach(page ${pages})
  string(REGEX REPLACE ".*<file>(.*)</file>.*" "docs/\\1" page ${page})
  get_filename_component(folder ${page} DIRECTORY)
  install(FILES ${page} DESTINATION ${CMAKE_INSTALL_DOCDIR}/${folder})
endforeach()
install(DIRECTORY examples DESTINATION ${CMAKE_INSTALL_DOCDIR})

# CPack's own generator of Debian packages lists files in the order of the disk: other bytes on another machine.
set(CPACK_GENERATOR External)
set(CPACK_EXTERNAL_ENABLE_STAGING ON)
set(CPACK_EXTERNAL_PACKAGE_SCRIPT ${packaging}/deb.cmake)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_MAPWRIGHT_SOURCES ${CMAKE_SOURCE_DIR})
include(CPack)
