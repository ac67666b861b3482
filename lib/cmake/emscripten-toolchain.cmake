# Emscripten's own toolchain file, from wherever its compiler is on the path: the preset `wasm` names this file.
find_program(GONIO_EM_CONFIG em-config)
mark_as_advanced(GONIO_EM_CONFIG)
if(NOT GONIO_EM_CONFIG)
    message(FATAL_ERROR "Emscripten is not on the path: apt-get install emscripten, or activate its SDK")
endif()
execute_process(COMMAND "${GONIO_EM_CONFIG}" EMSCRIPTEN_ROOT OUTPUT_VARIABLE gonio_emscripten_root
                OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
include("${gonio_emscripten_root}/cmake/Modules/Platform/Emscripten.cmake")
