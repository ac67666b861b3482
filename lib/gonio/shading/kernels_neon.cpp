#include <gonio/shading/kernels_impl.hpp>
#include <gonio/simd/pack.hpp>

namespace gonio::shading::detail {

namespace {
using S = simd::pack<float, simd::neon>;
}

constinit const Kernels kernels_neon{
    simd::InstructionSet::neon, "neon", S::lanes, shade_any<S, specular_kernels_neon>, irradiance_any<S>,
    approximate_any<S>};

} // namespace gonio::shading::detail
