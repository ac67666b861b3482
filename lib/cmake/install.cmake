# The library as a package: headers by room, the archive, the media modules, and gonio-config.cmake.
include(CMakePackageConfigHelpers)

set(gonio_package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/gonio")

install(TARGETS gonio EXPORT gonio-targets
        ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT library
        INCLUDES DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}")
install(TARGETS gonio-image gonio-color LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}/gonio" COMPONENT modules)

# Public headers only: not those under detail/, of a module, of a fitting program or of gonio-measure. A new one has to be
# listed in public-headers.txt too, which the test consumer.install compares.
install(DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}/gonio" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}" COMPONENT library
        FILES_MATCHING PATTERN "*.hpp"
        PATTERN "detail" EXCLUDE
        PATTERN "fit" EXCLUDE
        PATTERN "data" EXCLUDE
        REGEX "/gonio/(measure|media/image|media/color)$" EXCLUDE)

# The CIE's numbers are compiled in; their licence wants to go with them.
install(FILES "${CMAKE_CURRENT_SOURCE_DIR}/gonio/color/data/NOTICE" DESTINATION "${CMAKE_INSTALL_DOCDIR}"
        COMPONENT library RENAME NOTICE.cie-tables)

install(EXPORT gonio-targets NAMESPACE gonio:: DESTINATION "${gonio_package_dir}" COMPONENT library)
set(GONIO_MODULE_DIR "${CMAKE_INSTALL_LIBDIR}/gonio")
configure_package_config_file("${CMAKE_CURRENT_LIST_DIR}/gonio-config.cmake.in"
                              "${CMAKE_CURRENT_BINARY_DIR}/gonio-config.cmake"
                              INSTALL_DESTINATION "${gonio_package_dir}" PATH_VARS GONIO_MODULE_DIR)
# Before 1.0 a minor version may change the interface.
write_basic_package_version_file("${CMAKE_CURRENT_BINARY_DIR}/gonio-config-version.cmake"
                                 COMPATIBILITY SameMinorVersion)
install(FILES "${CMAKE_CURRENT_BINARY_DIR}/gonio-config.cmake" "${CMAKE_CURRENT_BINARY_DIR}/gonio-config-version.cmake"
        DESTINATION "${gonio_package_dir}" COMPONENT library)
