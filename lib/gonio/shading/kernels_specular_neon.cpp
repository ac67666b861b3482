#include <gonio/shading/kernels_specular_impl.hpp>
#include <gonio/simd/pack.hpp>

namespace gonio::shading::detail {

namespace {
using S = simd::pack<float, simd::neon>;
}

constinit const SpecularKernels specular_kernels_neon{simd::InstructionSet::neon, "neon", S::lanes, specular_any<S>,
                                                      specular_power_any<S>};

} // namespace gonio::shading::detail
