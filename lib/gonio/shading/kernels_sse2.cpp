#include <gonio/shading/kernels_impl.hpp>
#include <gonio/simd/pack.hpp>

namespace gonio::shading::detail {

namespace {
using S = simd::pack<float, simd::sse2>;
}

constinit const Kernels kernels_sse2{
    simd::InstructionSet::sse2, "sse2", S::lanes, shade_any<S, specular_kernels_sse2>, irradiance_any<S>,
    approximate_any<S>};

} // namespace gonio::shading::detail
