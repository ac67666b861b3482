#include <gonio/shading/kernels_specular.hpp>
#include <gonio/shading/kernels_specular_impl.hpp>

namespace gonio::shading {

const SpecularKernels& specular_kernels(simd::InstructionSet set) {
    if (!simd::available(set)) return detail::specular_kernels_scalar;
    switch (set) {
#if defined(__x86_64__)
    case simd::InstructionSet::sse2:
        return detail::specular_kernels_sse2;
    case simd::InstructionSet::avx2:
        return detail::specular_kernels_avx2;
    case simd::InstructionSet::avx512:
        return detail::specular_kernels_avx512;
#elif defined(__aarch64__)
    case simd::InstructionSet::neon:
        return detail::specular_kernels_neon;
#endif
    default:
        return detail::specular_kernels_scalar;
    }
}

} // namespace gonio::shading
