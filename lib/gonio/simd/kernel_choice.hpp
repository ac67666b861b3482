// Chooses among a room's tables of kernels, one per instruction set, by the set requested at run time.
//
// The names of the tables end in the name of the set, like the sources that gonio_kernel_sources() compiles:
// GONIO_CHOSEN_KERNELS(set, detail::kernels) is detail::kernels_avx2, or detail::kernels_scalar if this build or
// machine does not have the set.
#pragma once

#include <gonio/simd/dispatch.hpp>

namespace gonio::simd::detail {

#if defined(__x86_64__)

template<class Kernels>
const Kernels& chosen(InstructionSet set, const Kernels& scalar, const Kernels& sse2, const Kernels& avx2,
                      const Kernels& avx512) {
    if (!available(set)) return scalar;
    switch (set) {
    case InstructionSet::sse2:
        return sse2;
    case InstructionSet::avx2:
        return avx2;
    case InstructionSet::avx512:
        return avx512;
    default:
        return scalar;
    }
}

#define GONIO_CHOSEN_KERNELS(set, stem)                                                                                \
    ::gonio::simd::detail::chosen(set, stem##_scalar, stem##_sse2, stem##_avx2, stem##_avx512)

#elif defined(__aarch64__)

template<class Kernels>
const Kernels& chosen(InstructionSet set, const Kernels& scalar, const Kernels& neon) {
    return available(set) && set == InstructionSet::neon ? neon : scalar;
}

#define GONIO_CHOSEN_KERNELS(set, stem) ::gonio::simd::detail::chosen(set, stem##_scalar, stem##_neon)

#elif defined(__wasm_simd128__) && defined(GONIO_NO_SCALAR_KERNELS)

template<class Kernels>
const Kernels& chosen(InstructionSet /*set*/, const Kernels& wasm128) {
    return wasm128;
}

#define GONIO_CHOSEN_KERNELS(set, stem) ::gonio::simd::detail::chosen(set, stem##_wasm128)

#elif defined(__wasm_simd128__)

template<class Kernels>
const Kernels& chosen(InstructionSet set, const Kernels& scalar, const Kernels& wasm128) {
    return set == InstructionSet::wasm128 ? wasm128 : scalar;
}

#define GONIO_CHOSEN_KERNELS(set, stem) ::gonio::simd::detail::chosen(set, stem##_scalar, stem##_wasm128)

#else

template<class Kernels>
const Kernels& chosen(InstructionSet /*set*/, const Kernels& scalar) {
    return scalar;
}

#define GONIO_CHOSEN_KERNELS(set, stem) ::gonio::simd::detail::chosen(set, stem##_scalar)

#endif

} // namespace gonio::simd::detail
