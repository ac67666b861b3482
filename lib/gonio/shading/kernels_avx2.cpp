#include <gonio/shading/kernels_impl.hpp>
#include <gonio/simd/pack.hpp>

namespace gonio::shading::detail {

namespace {
using S = simd::pack<float, simd::avx2>;
}

constinit const Kernels kernels_avx2{
    simd::InstructionSet::avx2, "avx2", S::lanes, shade_any<S, specular_kernels_avx2>, irradiance_any<S>,
    approximate_any<S>};

} // namespace gonio::shading::detail
