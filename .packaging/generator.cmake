# Read by cpack once for each kind of package.

# Every time stamp in a package is the release's, whenever it is made.
if(NOT DEFINED ENV{SOURCE_DATE_EPOCH})
    execute_process(COMMAND date --utc --date "${CPACK_GONIO_VERSION_DATE}" +%s OUTPUT_VARIABLE epoch
                    OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
    set(ENV{SOURCE_DATE_EPOCH} "${epoch}")
endif()

if(CPACK_GENERATOR STREQUAL "DEB")
    set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
    set(CPACK_PRE_BUILD_SCRIPTS "${CPACK_GONIO_SOURCE}/.packaging/debian/stage.cmake")
    # Or it would be put before the synopsis of each package.
    set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${CPACK_DEFAULT_PACKAGE_DESCRIPTION_SUMMARY}")
    # The loader's cache: the shared library is in one of its folders.
    set(CPACK_DEBIAN_RUNTIME_PACKAGE_CONTROL_EXTRA "${CPACK_GONIO_SOURCE}/.packaging/debian/triggers")
else()
    set(CPACK_PACKAGING_INSTALL_PREFIX /)
    set(CPACK_PRE_BUILD_SCRIPTS "${CPACK_GONIO_SOURCE}/.packaging/archive.cmake")
    set(CPACK_PACKAGE_FILE_NAME "gonio-${CPACK_PACKAGE_VERSION}-linux-${CPACK_GONIO_PROCESSOR}")
endif()
