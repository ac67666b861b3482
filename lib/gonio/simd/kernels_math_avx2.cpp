#include <gonio/simd/array_math_impl.hpp>
#include <gonio/simd/pack.hpp>

namespace gonio::simd::detail {

constinit const ArrayMath array_math_avx2 = array_math_of<pack<float, avx2>>(InstructionSet::avx2);
constinit const ArrayMath array_math_twin_avx2 = array_math_of<twin<pack<float, avx2>>>(InstructionSet::avx2);

} // namespace gonio::simd::detail
