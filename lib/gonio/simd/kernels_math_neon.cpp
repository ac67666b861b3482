#include <gonio/simd/array_math_impl.hpp>
#include <gonio/simd/pack.hpp>

namespace gonio::simd::detail {

constinit const ArrayMath array_math_neon = array_math_of<pack<float, neon>>(InstructionSet::neon);

} // namespace gonio::simd::detail
