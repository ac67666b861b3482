#include <gonio/simd/array_math_impl.hpp>

namespace gonio::simd::detail {

constinit const ArrayMath array_math_scalar = array_math_of<float>(InstructionSet::scalar);

} // namespace gonio::simd::detail
