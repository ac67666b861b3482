#include <gonio/simd/array_math.hpp>
#include <gonio/simd/array_math_impl.hpp>

namespace gonio::simd {

const ArrayMath& array_math(InstructionSet set) {
    if (!available(set)) return detail::array_math_scalar;
    switch (set) {
#if defined(__x86_64__)
    case InstructionSet::sse2:
        return detail::array_math_sse2;
    case InstructionSet::avx2:
        return detail::array_math_avx2;
    case InstructionSet::avx512:
        return detail::array_math_avx512;
#elif defined(__aarch64__)
    case InstructionSet::neon:
        return detail::array_math_neon;
#endif
    default:
        return detail::array_math_scalar;
    }
}

const ArrayMath& array_math_of_twins(InstructionSet set) {
    if (!available(set)) return detail::array_math_scalar;
    switch (set) {
#if defined(__x86_64__)
    case InstructionSet::sse2:
        return detail::array_math_twin_sse2;
    case InstructionSet::avx2:
        return detail::array_math_twin_avx2;
    case InstructionSet::avx512:
        return detail::array_math_twin_avx512;
#elif defined(__aarch64__)
    case InstructionSet::neon:
        return detail::array_math_twin_neon;
#endif
    default:
        return detail::array_math_scalar;
    }
}

} // namespace gonio::simd
