#include <gonio/shading/kernels_specular_impl.hpp>
#include <gonio/simd/pack.hpp>

namespace gonio::shading::detail {

namespace {
using S = simd::pack<float, simd::sse2>;
}

constinit const SpecularKernels specular_kernels_sse2{simd::InstructionSet::sse2, "sse2", S::lanes, specular_any<S>,
                                                      specular_power_any<S>};

} // namespace gonio::shading::detail
