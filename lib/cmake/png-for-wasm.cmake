# The target gonio-png: libpng and zlib for WebAssembly. Compiled from the folders of their sources if these are given, as
# lib/wasm/build.sh does; else Emscripten's ports, which it downloads.
set(GONIO_LIBPNG_SOURCE "$ENV{GONIO_LIBPNG_SOURCE}" CACHE PATH "Folder of libpng's sources; empty: Emscripten's port")
set(GONIO_ZLIB_SOURCE "$ENV{GONIO_ZLIB_SOURCE}" CACHE PATH "Folder of zlib's sources; empty: Emscripten's port")

if(NOT GONIO_LIBPNG_SOURCE OR NOT GONIO_ZLIB_SOURCE)
    add_library(gonio-png INTERFACE)
    target_compile_options(gonio-png INTERFACE -sUSE_LIBPNG=1)
    target_link_options(gonio-png INTERFACE -sUSE_LIBPNG=1)
    return()
endif()

enable_language(C)
set(sources "")
foreach(name adler32 compress crc32 deflate inffast inflate inftrees trees zutil)
    list(APPEND sources "${GONIO_ZLIB_SOURCE}/${name}.c")
endforeach()
foreach(name png pngerror pngget pngmem pngpread pngread pngrio pngrtran pngrutil pngset pngtrans pngwio pngwrite
             pngwtran pngwutil)
    list(APPEND sources "${GONIO_LIBPNG_SOURCE}/${name}.c")
endforeach()
# Errors are thrown through libpng's frames, which WebAssembly unwinds: no setjmp, nor the simplified interface, which needs
# it. Pixels are read as they are, but for palettes and few bits, which are expanded, and nothing is printed.
file(READ "${GONIO_LIBPNG_SOURCE}/scripts/pnglibconf.h.prebuilt" configuration)
string(REGEX REPLACE "#define PNG_(SETJMP|SIMPLIFIED_[A-Z_]*|CONSOLE_IO|PROGRESSIVE_READ|READ_(ALPHA_MODE|BACKGROUND|\
BGR|COMPOSITE_NODIV|FILLER|GAMMA|GRAY_TO_RGB|INVERT|INVERT_ALPHA|PACKSWAP|QUANTIZE|RGB_TO_GRAY|SCALE_16_TO_8|SHIFT|STRIP_16_TO_8|\
STRIP_ALPHA|SWAP_ALPHA|USER_TRANSFORM))_SUPPORTED" "/* \\1: no */" configuration "${configuration}")
file(CONFIGURE OUTPUT "${PROJECT_BINARY_DIR}/png/pnglibconf.h" CONTENT "${configuration}" @ONLY)

add_library(gonio-png STATIC ${sources})
target_include_directories(gonio-png SYSTEM PUBLIC "${PROJECT_BINARY_DIR}/png" "${GONIO_LIBPNG_SOURCE}" "${GONIO_ZLIB_SOURCE}")
target_compile_options(gonio-png PRIVATE -w -Os -fwasm-exceptions)
# Sums of bytes one by one: the tables for words are 4096 bytes that do not compress.
target_compile_definitions(gonio-png PRIVATE Z_TESTW=0)
