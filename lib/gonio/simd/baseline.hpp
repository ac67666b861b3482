// The scalar of the widest set that every machine of the architecture has, for code that is compiled once: measurements
// and tests of packs.
#pragma once

#include <gonio/simd/native.hpp>
#include <gonio/simd/pack.hpp>

namespace gonio::simd {

#if defined(__x86_64__)
using Baseline = pack<float, sse2>;
#elif defined(__aarch64__)
using Baseline = pack<float, neon>;
#elif defined(__wasm_simd128__)
using Baseline = pack<float, wasm128>;
#else
using Baseline = float;
#endif

} // namespace gonio::simd
