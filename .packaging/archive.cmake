# Adds to the archive what its reader wants to see first.
file(COPY "${CPACK_GONIO_SOURCE}/LICENSE" "${CPACK_GONIO_SOURCE}/README.md"
     DESTINATION "${CPACK_TEMPORARY_INSTALL_DIRECTORY}/share/doc/gonio")

# Whatever the umask is.
execute_process(COMMAND chmod -R u=rwX,go=rX "${CPACK_TEMPORARY_INSTALL_DIRECTORY}" COMMAND_ERROR_IS_FATAL ANY)
