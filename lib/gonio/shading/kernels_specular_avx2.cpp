#include <gonio/shading/kernels_specular_impl.hpp>
#include <gonio/simd/pack.hpp>

namespace gonio::shading::detail {

namespace {
using S = simd::pack<float, simd::avx2>;
}

constinit const SpecularKernels specular_kernels_avx2{simd::InstructionSet::avx2, "avx2", S::lanes, specular_any<S>,
                                                      specular_power_any<S>};

} // namespace gonio::shading::detail
