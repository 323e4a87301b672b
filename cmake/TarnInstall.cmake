# What `cmake --install` puts into a prefix, and the Debian package that tools/package makes of it.
include(GNUInstallDirs)

# The programs do not need the tests to be built.
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON)

install(TARGETS tarn tarn-osmesa RUNTIME)
install(DIRECTORY shaders DESTINATION ${CMAKE_INSTALL_DATADIR}/tarn)
install(DIRECTORY assets DESTINATION ${CMAKE_INSTALL_DATADIR}/tarn PATTERN desktop EXCLUDE)
install(FILES assets/desktop/tarn.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications)
install(FILES assets/desktop/tarn.svg DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps)
# The man page and the shells' completions are what the program says of itself.
find_program(TARN_PYTHON3 python3)
if(TARN_PYTHON3)
  install(CODE "execute_process(
    COMMAND \"${TARN_PYTHON3}\" \"${PROJECT_SOURCE_DIR}/tools/shell_files\" --program \"$<TARGET_FILE:tarn-osmesa>\"
            --out \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_DATADIR}\"
    COMMAND_ERROR_IS_FATAL ANY OUTPUT_QUIET)")
else()
  message(STATUS "python3 is missing: no man page and no completions will be installed")
endif()
install(FILES README.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY docs/ DESTINATION ${CMAKE_INSTALL_DOCDIR}/docs FILES_MATCHING PATTERN *.md)
install(FILES cmake/lintian-overrides DESTINATION ${CMAKE_INSTALL_DATADIR}/lintian/overrides RENAME tarn)
# Under the names that Debian's policy gives them (12.5, 12.7).
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME copyright)
find_program(TARN_GZIP gzip REQUIRED)
set(changelog ${PROJECT_BINARY_DIR}/package/changelog)
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
# Whoever makes a package puts a name to it, as with Debian's own tools.
set(maintainer "Tarn contributors <tarn@example.org>")
if(DEFINED ENV{DEBEMAIL})
  set(maintainer "$ENV{DEBFULLNAME} <$ENV{DEBEMAIL}>")
endif()
file(WRITE ${changelog}
  "tarn (${PROJECT_VERSION}) unstable; urgency=medium\n\n  * What has changed is in CHANGELOG.md.\n\n -- ${maintainer}  ${date}\n")
foreach(name changelog CHANGELOG.md)
  set(source ${changelog})
  if(name STREQUAL CHANGELOG.md)
    set(source ${PROJECT_SOURCE_DIR}/CHANGELOG.md)
  endif()
  execute_process(COMMAND ${TARN_GZIP} -9nc ${source} OUTPUT_FILE ${PROJECT_BINARY_DIR}/package/${name}.gz
                  COMMAND_ERROR_IS_FATAL ANY)
  install(FILES ${PROJECT_BINARY_DIR}/package/${name}.gz DESTINATION ${CMAKE_INSTALL_DOCDIR})
endforeach()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME tarn)
set(CPACK_PACKAGE_CONTACT "${maintainer}")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "lake viewer that knows what its speed costs in accuracy")
set(CPACK_PACKAGE_DESCRIPTION
  "Tarn loads a lake scene from OBJ files, fills it with moving water and shows\nrefraction, reflection, absorption, caustics, glow and the view from under\nwater. A ray-traced reference of the same scene tells the error of every\napproximation, and every setting has its measured cost.")
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "libgl1-mesa-dri, libjs-chart.js")
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/package)
include(CPack)
