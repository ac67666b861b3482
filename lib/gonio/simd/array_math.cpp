#include <gonio/simd/array_math.hpp>
#include <gonio/simd/array_math_impl.hpp>
#include <gonio/simd/kernel_choice.hpp>

namespace gonio::simd {

const ArrayMath& array_math(InstructionSet set) {
    return GONIO_CHOSEN_KERNELS(set, detail::array_math);
}

const ArrayMath& array_math_of_twins(InstructionSet set) {
    return GONIO_CHOSEN_KERNELS(set, detail::array_math_twin);
}

} // namespace gonio::simd
