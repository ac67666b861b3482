#include <gonio/preview/kernels_intensity_impl.hpp>
#include <gonio/simd/pack.hpp>

namespace gonio::preview::detail {

namespace {
using S = simd::pack<float, simd::avx512>;
}

constinit const IntensityKernels kernels_intensity_avx512{simd::InstructionSet::avx512, multiply_any_lobe<S>,
                                                          multiply_any_web<S>};

} // namespace gonio::preview::detail
