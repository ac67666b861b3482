#include <gonio/bake/kernels.hpp>

namespace gonio::bake {

const Kernels& kernels(simd::InstructionSet set) {
    if (!simd::available(set)) return detail::kernels_scalar;
    switch (set) {
#if defined(__x86_64__)
    case simd::InstructionSet::sse2:
        return detail::kernels_sse2;
    case simd::InstructionSet::avx2:
        return detail::kernels_avx2;
    case simd::InstructionSet::avx512:
        return detail::kernels_avx512;
#elif defined(__aarch64__)
    case simd::InstructionSet::neon:
        return detail::kernels_neon;
#endif
    default:
        return detail::kernels_scalar;
    }
}

} // namespace gonio::bake
