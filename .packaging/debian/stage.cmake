# What Debian's policy wants in each package beside the component's files: its copyright and its changelog, and
# documents compressed. Runs between installing and packing; each component's files are in a folder of its name.
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC) # of SOURCE_DATE_EPOCH

foreach(component IN LISTS CPACK_COMPONENTS_ALL)
    string(TOUPPER "${component}" variable)
    set(package "${CPACK_DEBIAN_${variable}_PACKAGE_NAME}")
    set(share "${CPACK_TEMPORARY_DIRECTORY}/${component}/usr/share")
    set(documents "${share}/doc/${package}")

    # Outside of packages all components share one folder.
    file(GLOB notices "${share}/doc/*/NOTICE*")
    file(MAKE_DIRECTORY "${share}/notices")
    file(COPY ${notices} DESTINATION "${share}/notices")
    file(REMOVE_RECURSE "${share}/doc")
    file(MAKE_DIRECTORY "${share}/doc")
    file(RENAME "${share}/notices" "${documents}")
    file(COPY "${CPACK_GONIO_SOURCE}/.packaging/debian/copyright" DESTINATION "${documents}")
    file(WRITE "${documents}/changelog" "gonio (${CPACK_PACKAGE_VERSION}) unstable; urgency=medium\n\n"
         "  * Release ${CPACK_PACKAGE_VERSION}.\n\n -- ${CPACK_PACKAGE_CONTACT}  ${date}\n")

    file(GLOB compressed "${documents}/changelog" "${share}/man/man1/*.1")
    # -n: without the time.
    execute_process(COMMAND gzip --best --no-name ${compressed} COMMAND_ERROR_IS_FATAL ANY)

    file(GLOB archives "${CPACK_TEMPORARY_DIRECTORY}/${component}/usr/lib/*.a"
                       "${CPACK_TEMPORARY_DIRECTORY}/${component}/usr/lib/*/*.a")
    foreach(archive IN LISTS archives)
        execute_process(COMMAND strip --strip-debug --remove-section=.comment --enable-deterministic-archives "${archive}"
                        COMMAND_ERROR_IS_FATAL ANY)
    endforeach()
endforeach()

# Whatever the umask is.
execute_process(COMMAND chmod -R u=rwX,go=rX "${CPACK_TEMPORARY_DIRECTORY}" COMMAND_ERROR_IS_FATAL ANY)
