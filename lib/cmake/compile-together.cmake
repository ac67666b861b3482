# GONIO_UNITY: the sources of a folder as one, which parses headers and generates the code of templates once for all of them. For
# .ci/run, which compiles everything: a change of one source compiles its folder again.
option(GONIO_UNITY "Compile the sources of some folders together" OFF)

# gonio_compile_together(<target> <folder>…): the target's sources in each of these folders. Two sources of such a folder may not
# have the same name in their unnamed namespaces. Sources with options of their own stay alone.
function(gonio_compile_together target)
    if(NOT GONIO_UNITY)
        return()
    endif()
    get_target_property(sources ${target} SOURCES)
    foreach(source IN LISTS sources)
        get_filename_component(folder "${source}" DIRECTORY)
        if(folder IN_LIST ARGN)
            string(MAKE_C_IDENTIFIER "${folder}" group)
            set_source_files_properties("${source}" PROPERTIES UNITY_GROUP ${group})
        endif()
    endforeach()
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
endfunction()
