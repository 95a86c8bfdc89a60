# Where things go when installed: programs in bin, assets and demos in share/trocar. `cpack -G DEB` makes a package.
install(DIRECTORY "${CMAKE_SOURCE_DIR}/assets" "${CMAKE_SOURCE_DIR}/demos"
        DESTINATION "${CMAKE_INSTALL_DATADIR}/trocar")

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "The Trocar authors <trocar@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "Workbench for teaching surgical robots by demonstration")
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
include(CPack)
