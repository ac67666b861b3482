#include <gonio/color/kernels_impl.hpp>
#include <gonio/simd/pack.hpp>

namespace gonio::color::detail {

constinit const Kernels kernels_sse2 = kernels_of<simd::pack<float, simd::sse2>>(simd::InstructionSet::sse2, "sse2");

} // namespace gonio::color::detail
