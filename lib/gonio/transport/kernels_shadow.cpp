#include <gonio/simd/kernel_choice.hpp>
#include <gonio/transport/kernels_shadow.hpp>
#include <gonio/transport/kernels_shadow_impl.hpp>

namespace gonio::transport {

const ShadowKernels& shadow_kernels(simd::InstructionSet set) {
    return GONIO_CHOSEN_KERNELS(set, detail::kernels_shadow);
}

} // namespace gonio::transport
