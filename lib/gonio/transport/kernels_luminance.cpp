#include <gonio/simd/kernel_choice.hpp>
#include <gonio/transport/kernels_luminance.hpp>
#include <gonio/transport/kernels_luminance_impl.hpp>

namespace gonio::transport {

const LuminanceKernels& luminance_kernels(simd::InstructionSet set) {
    return GONIO_CHOSEN_KERNELS(set, detail::kernels_luminance);
}

} // namespace gonio::transport
