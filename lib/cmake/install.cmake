# The library as a package: headers by room, the archive, the media modules, and gonio-config.cmake.
include(CMakePackageConfigHelpers)

set(gonio_package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/gonio")

install(TARGETS gonio EXPORT gonio-targets
        ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT library
        INCLUDES DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}")
install(TARGETS gonio-image gonio-color LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}/gonio" COMPONENT modules)

# The public headers, which are a list: what is not on it may change at any time. The test consumer.install compares the
# list with what was installed and compiles each header against nothing but these.
file(STRINGS "${CMAKE_CURRENT_LIST_DIR}/public-headers.txt" gonio_public_headers)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${CMAKE_CURRENT_LIST_DIR}/public-headers.txt")
foreach(header IN LISTS gonio_public_headers)
    get_filename_component(folder "${header}" DIRECTORY)
    install(FILES "${CMAKE_CURRENT_SOURCE_DIR}/${header}" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/${folder}"
            COMPONENT library)
endforeach()

# For editors, which complete and check JSON by it.
foreach(schema scene/rig asset/asset asset/environment asset/manifest asset/prefilter asset/texture)
    install(FILES "${CMAKE_CURRENT_SOURCE_DIR}/gonio/${schema}.schema.json" DESTINATION "${CMAKE_INSTALL_DATADIR}/gonio"
            COMPONENT library)
endforeach()

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
