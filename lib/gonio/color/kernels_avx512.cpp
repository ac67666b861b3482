#include <gonio/color/kernels_impl.hpp>
#include <gonio/simd/pack.hpp>

namespace gonio::color::detail {

constinit const Kernels kernels_avx512 =
    kernels_of<simd::pack<float, simd::avx512>>(simd::InstructionSet::avx512, "avx512");

} // namespace gonio::color::detail
