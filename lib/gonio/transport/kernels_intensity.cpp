#include <gonio/simd/kernel_choice.hpp>
#include <gonio/transport/kernels_intensity.hpp>
#include <gonio/transport/kernels_intensity_impl.hpp>

namespace gonio::transport {

const IntensityKernels& intensity_kernels(simd::InstructionSet set) {
    return GONIO_CHOSEN_KERNELS(set, detail::kernels_intensity);
}

} // namespace gonio::transport
