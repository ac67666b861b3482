#include <gonio/preview/kernels_intensity_impl.hpp>

namespace gonio::preview::detail {

constinit const IntensityKernels kernels_intensity_scalar{simd::InstructionSet::scalar, multiply_any_lobe<float>,
                                                          multiply_any_web<float>};

} // namespace gonio::preview::detail
