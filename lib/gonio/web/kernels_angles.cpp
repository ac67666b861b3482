#include <gonio/simd/kernel_choice.hpp>
#include <gonio/web/kernels_angles.hpp>

namespace gonio::web_detail {

const AngleKernels& angle_kernels(simd::InstructionSet set) {
    return GONIO_CHOSEN_KERNELS(set, detail::angle_kernels);
}

} // namespace gonio::web_detail
