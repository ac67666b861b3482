# gonio-fmt: fmt with the parts of it that are no templates compiled once, in base/fmt_library.cpp. Header-only fmt compiles
# them again in each of 170 files, which is a third of their time; the shared library costs every start of the tool, and
# Debian has no archive of it. Another fmt than 9, whose
# parts are others, stays header-only.
add_library(gonio-fmt INTERFACE)
if(fmt_VERSION VERSION_GREATER_EQUAL 9 AND fmt_VERSION VERSION_LESS 10)
    get_target_property(gonio_fmt_includes fmt::fmt INTERFACE_INCLUDE_DIRECTORIES)
    if(gonio_fmt_includes)
        target_include_directories(gonio-fmt SYSTEM INTERFACE ${gonio_fmt_includes})
    endif()
    set(gonio_fmt_source fmt_library.cpp)
    # Neither std::locale, which brings all of its facets, nor the software of 128-bit numbers.
    if(EMSCRIPTEN)
        target_compile_definitions(gonio-fmt INTERFACE "FMT_STATIC_THOUSANDS_SEPARATOR=','" FMT_USE_LONG_DOUBLE=0
                                                       FMT_USE_INT128=0)
    endif()
else()
    target_link_libraries(gonio-fmt INTERFACE fmt::fmt-header-only)
    set(gonio_fmt_source "")
endif()
