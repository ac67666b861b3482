# One interface target that every target of the project links: language level, warnings, floating-point rules.
add_library(gonio-build-flags INTERFACE)
target_compile_features(gonio-build-flags INTERFACE cxx_std_20)
target_compile_options(gonio-build-flags INTERFACE
    -Wall -Wextra -Wpedantic -Wconversion -Wsign-conversion -Wold-style-cast -Wnon-virtual-dtor
    $<$<NOT:$<BOOL:${GONIO_UNITY}>>:-Wshadow> # sources compiled together see each other's names
    -ffp-contract=off        # a*b+c rounds the same on every machine; fma is called by name
    -fno-math-errno          # lets sqrt become one instruction; nobody reads errno
    -fvisibility=hidden -fvisibility-inlines-hidden
    -ffunction-sections # the tool leaves out what it does not call (--gc-sections)
    # g++ 12 at -O2 drops the rounding in double->float->double pairs (tests/unit/compiler_guard.cpp)
    $<$<CXX_COMPILER_ID:GNU>:-fno-tree-slp-vectorize>
    # the vector types of simd/ never cross a function that is not inlined or of their own instruction set
    $<$<CXX_COMPILER_ID:GNU>:-Wno-psabi>
    # false in g++ 12 wherever std::string's operator+ is inlined (GCC bugs 105329 and 105651); clang and
    # AddressSanitizer look at the same code
    $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict;-Wno-stringop-overflow;-Wno-stringop-overread;-Wno-array-bounds>
    $<$<AND:$<BOOL:${EMSCRIPTEN}>,$<BOOL:${GONIO_WASM_SIMD}>>:-msimd128>
    $<$<BOOL:${GONIO_WERROR}>:-Werror>)
if(GONIO_SANITIZE)
    target_compile_options(gonio-build-flags INTERFACE -fsanitize=${GONIO_SANITIZE} -fno-omit-frame-pointer
                           -fno-sanitize-recover=all)
    target_link_options(gonio-build-flags INTERFACE -fsanitize=${GONIO_SANITIZE})
endif()
