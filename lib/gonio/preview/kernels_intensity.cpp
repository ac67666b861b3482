#include <gonio/preview/kernels_intensity.hpp>
#include <gonio/preview/kernels_intensity_impl.hpp>
#include <gonio/simd/kernel_choice.hpp>

namespace gonio::preview {

const IntensityKernels& intensity_kernels(simd::InstructionSet set) {
    return GONIO_CHOSEN_KERNELS(set, detail::kernels_intensity);
}

} // namespace gonio::preview
