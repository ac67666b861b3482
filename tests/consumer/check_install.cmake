# Installs the library into an empty folder and looks at what came there.
file(REMOVE_RECURSE "${STAGE}")
foreach(component library modules)
    execute_process(COMMAND "${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${STAGE}" --component ${component}
                    RESULT_VARIABLE status OUTPUT_QUIET)
    if(NOT status EQUAL 0)
        message(FATAL_ERROR "installing ${component} failed")
    endif()
endforeach()

foreach(wanted "${LIBDIR}/libgonio.a" "${LIBDIR}/gonio/gonio-image.so" "${LIBDIR}/gonio/gonio-color.so"
               "${LIBDIR}/cmake/gonio/gonio-config.cmake" "${LIBDIR}/cmake/gonio/gonio-config-version.cmake"
               "${LIBDIR}/cmake/gonio/gonio-targets.cmake")
    if(NOT EXISTS "${STAGE}/${wanted}")
        message(FATAL_ERROR "not installed: ${wanted}")
    endif()
endforeach()

# Exactly the public headers: each room's own, none of detail/, of a module or of a fitting program.
file(GLOB_RECURSE installed RELATIVE "${STAGE}/${INCLUDEDIR}" "${STAGE}/${INCLUDEDIR}/*")
file(GLOB_RECURSE public RELATIVE "${SOURCE}/lib" "${SOURCE}/lib/gonio/*.hpp")
list(FILTER public EXCLUDE REGEX "/(detail|fit)/|^gonio/media/(image|color)/")
list(SORT installed)
list(SORT public)
if(NOT installed STREQUAL public)
    message(FATAL_ERROR "installed headers:\n${installed}\npublic headers of the tree:\n${public}")
endif()

# The package must work wherever it is moved to, so no file of it may name where it was built or staged.
file(GLOB package "${STAGE}/${LIBDIR}/cmake/gonio/*.cmake")
foreach(file IN LISTS package)
    file(READ "${file}" text)
    foreach(place "${SOURCE}" "${BUILD}" "${STAGE}")
        string(FIND "${text}" "${place}" found)
        if(NOT found EQUAL -1)
            message(FATAL_ERROR "${file} names ${place}")
        endif()
    endforeach()
endforeach()
