#include <gonio/shading/kernels_impl.hpp>
#include <gonio/simd/pack.hpp>

namespace gonio::shading::detail {

namespace {
using S = simd::pack<float, simd::avx512>;
}

constinit const Kernels kernels_avx512{simd::InstructionSet::avx512,          "avx512",          S::lanes,
                                       shade_any<S, specular_kernels_avx512>, irradiance_any<S>, approximate_any<S>};

} // namespace gonio::shading::detail
