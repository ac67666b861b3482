#include <gonio/simd/array_math_impl.hpp>
#include <gonio/simd/pack.hpp>

namespace gonio::simd::detail {

constinit const ArrayMath array_math_neon = array_math_of<pack<float, neon>>(InstructionSet::neon);
constinit const ArrayMath array_math_twin_neon = array_math_of<twin<pack<float, neon>>>(InstructionSet::neon);

} // namespace gonio::simd::detail
