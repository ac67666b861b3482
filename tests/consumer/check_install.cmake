# Installs every component into an empty folder and looks at what came there.
file(REMOVE_RECURSE "${STAGE}")
foreach(component tool runtime development modules)
    execute_process(COMMAND "${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${STAGE}" --component ${component}
                    RESULT_VARIABLE status OUTPUT_QUIET)
    if(NOT status EQUAL 0)
        message(FATAL_ERROR "installing ${component} failed")
    endif()
endforeach()

set(shared "")
if(SHARED)
    set(shared "${LIBDIR}/libgonio.so" "${LIBDIR}/cmake/gonio/gonio-shared-targets.cmake")
endif()
foreach(wanted "${LIBDIR}/libgonio.a" "${LIBDIR}/gonio/gonio-image.so" "${LIBDIR}/gonio/gonio-writers.so"
               "${LIBDIR}/gonio/gonio-color.so" "${LIBDIR}/gonio/gonio-pdf.so"
               "${LIBDIR}/cmake/gonio/gonio-config.cmake" "${LIBDIR}/cmake/gonio/gonio-config-version.cmake"
               "${LIBDIR}/cmake/gonio/gonio-targets.cmake" "${LIBDIR}/pkgconfig/gonio.pc" "share/gonio/rig.schema.json"
               "bin/gonio" "share/man/man1/gonio.1" "share/man/man1/gonio-bake.1"
               "share/bash-completion/completions/gonio" "share/zsh/site-functions/_gonio"
               "share/fish/vendor_completions.d/gonio.fish" ${shared})
    if(NOT EXISTS "${STAGE}/${wanted}")
        message(FATAL_ERROR "not installed: ${wanted}")
    endif()
endforeach()

# Exactly the headers of the manifest: one that is added or goes is a change of the interface, made on purpose.
file(GLOB_RECURSE installed RELATIVE "${STAGE}/${INCLUDEDIR}" "${STAGE}/${INCLUDEDIR}/*")
file(STRINGS "${SOURCE}/lib/cmake/public-headers.txt" public)
set(unlisted ${installed})
list(REMOVE_ITEM unlisted ${public})
set(missing ${public})
list(REMOVE_ITEM missing ${installed})
if(unlisted OR missing)
    message(FATAL_ERROR "lib/cmake/public-headers.txt differs from what is installed\n"
                        "installed and not listed: ${unlisted}\nlisted and not installed: ${missing}")
endif()

# The package must work wherever it is moved to, so no file of it may name where it was built or staged.
file(GLOB package "${STAGE}/${LIBDIR}/cmake/gonio/*.cmake" "${STAGE}/${LIBDIR}/pkgconfig/*.pc")
foreach(file IN LISTS package)
    file(READ "${file}" text)
    foreach(place "${SOURCE}" "${BUILD}" "${STAGE}")
        string(FIND "${text}" "${place}" found)
        if(NOT found EQUAL -1)
            message(FATAL_ERROR "${file} names ${place}")
        endif()
    endforeach()
endforeach()
