# The library as a package, in components: `runtime` (the shared object), `development` (headers by room, the archive,
# gonio-config.cmake, gonio.pc) and `modules` (the media modules). The tool's component is in cli/install.cmake.
include(CMakePackageConfigHelpers)

set(gonio_package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/gonio")

install(TARGETS gonio EXPORT gonio-targets
        ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT development
        INCLUDES DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}")
install(EXPORT gonio-targets NAMESPACE gonio:: DESTINATION "${gonio_package_dir}" COMPONENT development)
if(GONIO_SHARED)
    install(TARGETS gonio-shared EXPORT gonio-shared-targets
            LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT runtime NAMELINK_COMPONENT development
            INCLUDES DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}")
    install(EXPORT gonio-shared-targets NAMESPACE gonio:: DESTINATION "${gonio_package_dir}" COMPONENT development)
endif()
if(GONIO_MODULES)
    install(TARGETS gonio-image gonio-writers gonio-color gonio-pdf
            LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}/gonio" COMPONENT modules)
endif()

# The public headers, which are a list: what is not on it may change at any time. The test consumer.install compares the
# list with what was installed and compiles each header against nothing but these.
file(STRINGS "${CMAKE_CURRENT_LIST_DIR}/public-headers.txt" gonio_public_headers)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${CMAKE_CURRENT_LIST_DIR}/public-headers.txt")
foreach(header IN LISTS gonio_public_headers)
    get_filename_component(folder "${header}" DIRECTORY)
    install(FILES "${CMAKE_CURRENT_SOURCE_DIR}/${header}" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/${folder}"
            COMPONENT development)
endforeach()

# For editors, which complete and check JSON by it.
foreach(schema scene/rig asset/asset asset/environment asset/manifest asset/prefilter asset/texture)
    install(FILES "${CMAKE_CURRENT_SOURCE_DIR}/gonio/${schema}.schema.json" DESTINATION "${CMAKE_INSTALL_DATADIR}/gonio"
            COMPONENT development)
endforeach()

# The CIE's numbers are compiled in; their licence wants to go with them.
foreach(component tool runtime development)
    install(FILES "${CMAKE_CURRENT_SOURCE_DIR}/gonio/color/data/NOTICE" DESTINATION "${CMAKE_INSTALL_DOCDIR}"
            COMPONENT ${component} RENAME NOTICE.cie-tables)
endforeach()

# The package finds itself, its modules and its tool relative to its own place.
set(gonio_module_dir "${CMAKE_INSTALL_LIBDIR}/gonio")
set(gonio_bin_dir "${CMAKE_INSTALL_BINDIR}")
configure_package_config_file("${CMAKE_CURRENT_LIST_DIR}/gonio-config.cmake.in"
                              "${CMAKE_CURRENT_BINARY_DIR}/gonio-config.cmake"
                              INSTALL_DESTINATION "${gonio_package_dir}" PATH_VARS gonio_module_dir gonio_bin_dir)
# Before 1.0 a minor version may change the interface.
write_basic_package_version_file("${CMAKE_CURRENT_BINARY_DIR}/gonio-config-version.cmake"
                                 COMPATIBILITY SameMinorVersion)
install(FILES "${CMAKE_CURRENT_BINARY_DIR}/gonio-config.cmake" "${CMAKE_CURRENT_BINARY_DIR}/gonio-config-version.cmake"
        DESTINATION "${gonio_package_dir}" COMPONENT development)

# For builds that ask pkg-config. Where there is a shared object it is linked, and it brings its libraries; the archive
# needs them named.
set(gonio_pc_archive_libraries "")
foreach(library IN ITEMS ${gonio_pugixml} ${CMAKE_DL_LIBS} -pthread)
    if(NOT library MATCHES "^-")
        string(PREPEND library "-l")
    endif()
    list(APPEND gonio_pc_archive_libraries "${library}")
endforeach()
list(JOIN gonio_pc_archive_libraries " " gonio_pc_archive_libraries)
if(GONIO_SHARED)
    set(gonio_pc_libraries "-L\${libdir} -lgonio\nLibs.private: ${gonio_pc_archive_libraries}")
else()
    set(gonio_pc_libraries "-L\${libdir} -lgonio ${gonio_pc_archive_libraries}")
endif()
file(RELATIVE_PATH gonio_pc_prefix "/${CMAKE_INSTALL_LIBDIR}/pkgconfig" "/") # "../../"
configure_file("${CMAKE_CURRENT_LIST_DIR}/gonio.pc.in" "${CMAKE_CURRENT_BINARY_DIR}/gonio.pc" @ONLY)
install(FILES "${CMAKE_CURRENT_BINARY_DIR}/gonio.pc" DESTINATION "${CMAKE_INSTALL_LIBDIR}/pkgconfig"
        COMPONENT development)
