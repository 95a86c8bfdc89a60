# Where things go when installed: programs in bin, the media plugin in lib/trocar (engine/CMakeLists.txt), assets and demos
# in share/trocar. `cpack -G DEB` in a build folder makes a package.
install(DIRECTORY "${CMAKE_SOURCE_DIR}/assets" "${CMAKE_SOURCE_DIR}/demos"
        DESTINATION "${CMAKE_INSTALL_DATADIR}/trocar")
install(FILES "${CMAKE_SOURCE_DIR}/README.md" "${CMAKE_SOURCE_DIR}/CHANGELOG.md" DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/trocar")
install(FILES "${CMAKE_SOURCE_DIR}/LICENSE" DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/trocar" RENAME copyright)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME trocar)
set(CPACK_PACKAGE_CONTACT "The Trocar authors <trocar@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "Workbench for teaching surgical robots by demonstration")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# What is loaded by name, and so not found by dpkg-shlibdeps.
set(CPACK_DEBIAN_PACKAGE_DEPENDS "libosmesa6, fonts-inter, fonts-dejavu-core, fonts-font-awesome")
# Loaded when a SpaceMouse is asked for.
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "libspnav0, spacenavd")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "libgl1")
include(CPack)
