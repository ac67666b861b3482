#include <gonio/shading/kernels_impl.hpp>

namespace gonio::shading::detail {

constinit const Kernels kernels_scalar{
    simd::InstructionSet::scalar, "scalar", 1, shade_any<float, specular_kernels_scalar>, irradiance_any<float>,
    approximate_any<float>};

} // namespace gonio::shading::detail
