// Native<Isa> of the processor that is compiled for.
#pragma once

#if defined(__x86_64__)
#include <gonio/simd/native_x86.hpp>
#elif defined(__aarch64__)
#include <gonio/simd/native_neon.hpp>
#elif defined(__wasm_simd128__)
#include <gonio/simd/native_wasm.hpp>
#endif
