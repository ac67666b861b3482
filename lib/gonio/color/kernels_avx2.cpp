#include <gonio/color/kernels_impl.hpp>
#include <gonio/simd/pack.hpp>

namespace gonio::color::detail {

constinit const Kernels kernels_avx2 = kernels_of<simd::pack<float, simd::avx2>>(simd::InstructionSet::avx2, "avx2");

} // namespace gonio::color::detail
