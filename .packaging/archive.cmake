# Adds to the archive what its reader wants to see first.
file(COPY "${CPACK_GONIO_SOURCE}/LICENSE" "${CPACK_GONIO_SOURCE}/README.md"
     DESTINATION "${CPACK_TEMPORARY_INSTALL_DIRECTORY}/share/doc/gonio")
