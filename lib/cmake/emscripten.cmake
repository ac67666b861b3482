# What the library needs where Emscripten compiles it to WebAssembly. Included before lib/, in place of find_package.

option(GONIO_WASM_SIMD "Compile for WebAssembly with SIMD128; without it, for every WebAssembly" ON)
include(CMakeDependentOption)
# A tenth of a module; the tests compare with them.
cmake_dependent_option(GONIO_WASM_SCALAR "Compile the plain kernels beside those for SIMD128" "${BUILD_TESTING}" GONIO_WASM_SIMD ON)

# What profiles need: read, measured, drawn, baked. Pictures would take five times as long.
option(GONIO_WASM_SMALL "Optimise all for size, without the rooms that profiles do not need" OFF)
if(GONIO_WASM_SMALL)
    add_compile_definitions(GONIO_NO_EXPLANATIONS) # a tenth of it are sentences that `gonio explain` prints
endif()
# A fifth of what is compiled to be small. What is to be quick is not compiled like this (../CMakeLists.txt).
option(GONIO_WASM_LTO "Optimise modules when they are linked; libgonio.a is then for this Emscripten alone" ${GONIO_WASM_SMALL})
if(GONIO_WASM_LTO)
    add_compile_options(-flto)
    # What is to be inlined or to work on vectors is so before it is linked; the linker's share of both is larger and not quicker.
    add_link_options(-flto -Wl,-mllvm,-inline-threshold=0,-mllvm,-vectorize-loops=false,-mllvm,-vectorize-slp=false)
endif()

# Every engine with SIMD has these instructions, which are shorter than what stands for them (those of bulk memory are too, but
# need threads for `thread_local`). There are no threads that could initialise a static variable twice.
if(GONIO_WASM_SIMD)
    add_compile_options(-mnontrapping-fptoint -msign-ext)
endif()
add_compile_options($<$<COMPILE_LANGUAGE:CXX>:-fno-threadsafe-statics>)

# Header-only libraries are the same for every machine, but their CMake packages either refuse a processor with 32 bits or
# name the folder where this machine's C library also has its headers. So the folders of just these libraries are linked
# into the build.
set(gonio_headers "${PROJECT_BINARY_DIR}/headers")
file(MAKE_DIRECTORY "${gonio_headers}")
function(gonio_add_headers target header)
    string(MAKE_C_IDENTIFIER "GONIO_${header}_DIR" variable)
    string(TOUPPER "${variable}" variable)
    find_path(${variable} "${header}" PATHS /usr/local/include /usr/include NO_CMAKE_FIND_ROOT_PATH REQUIRED)
    mark_as_advanced(${variable})
    get_filename_component(folder "${header}" DIRECTORY)
    file(CREATE_LINK "${${variable}}/${folder}" "${gonio_headers}/${folder}" SYMBOLIC)
    add_library(${target} INTERFACE IMPORTED)
    target_include_directories(${target} SYSTEM INTERFACE "${gonio_headers}")
endfunction()
gonio_add_headers(glm::glm glm/glm.hpp)
gonio_add_headers(tl::expected tl/expected.hpp)
gonio_add_headers(fmt::fmt fmt/format.h)
gonio_add_headers(nlohmann_json::nlohmann_json nlohmann/json.hpp)
add_library(fmt::fmt-header-only INTERFACE IMPORTED)
target_link_libraries(fmt::fmt-header-only INTERFACE fmt::fmt)
target_compile_definitions(fmt::fmt-header-only INTERFACE FMT_HEADER_ONLY=1)
file(STRINGS "${gonio_headers}/fmt/core.h" fmt_VERSION REGEX "#define FMT_VERSION [0-9]+")
string(REGEX REPLACE ".* ([0-9]+)([0-9][0-9])([0-9][0-9])$" "\\1.\\2.\\3" fmt_VERSION "${fmt_VERSION}")

add_library(Threads::Threads INTERFACE IMPORTED) # none: loops run on the caller
