#include <gonio/preview/kernels_intensity_impl.hpp>
#include <gonio/simd/pack.hpp>

namespace gonio::preview::detail {

namespace {
using S = simd::pack<float, simd::sse2>;
}

constinit const IntensityKernels kernels_intensity_sse2{simd::InstructionSet::sse2, multiply_any_lobe<S>,
                                                        multiply_any_web<S>};

} // namespace gonio::preview::detail
