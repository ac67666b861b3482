#include <gonio/simd/array_math_impl.hpp>
#include <gonio/simd/pack.hpp>

namespace gonio::simd::detail {

constinit const ArrayMath array_math_sse2 = array_math_of<pack<float, sse2>>(InstructionSet::sse2);
constinit const ArrayMath array_math_twin_sse2 = array_math_of<twin<pack<float, sse2>>>(InstructionSet::sse2);

} // namespace gonio::simd::detail
