#include <gonio/shading/kernels_specular_impl.hpp>

namespace gonio::shading::detail {

constinit const SpecularKernels specular_kernels_scalar{simd::InstructionSet::scalar, "scalar", 1, specular_any<float>,
                                                        specular_power_any<float>};

} // namespace gonio::shading::detail
