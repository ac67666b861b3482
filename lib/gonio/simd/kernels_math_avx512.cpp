#include <gonio/simd/array_math_impl.hpp>
#include <gonio/simd/pack.hpp>

namespace gonio::simd::detail {

constinit const ArrayMath array_math_avx512 = array_math_of<pack<float, avx512>>(InstructionSet::avx512);
constinit const ArrayMath array_math_twin_avx512 = array_math_of<twin<pack<float, avx512>>>(InstructionSet::avx512);

} // namespace gonio::simd::detail
