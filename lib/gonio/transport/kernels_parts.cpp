#include <gonio/simd/kernel_choice.hpp>
#include <gonio/transport/kernels_parts.hpp>
#include <gonio/transport/kernels_parts_impl.hpp>

namespace gonio::transport {

const PartKernels& part_kernels(simd::InstructionSet set) {
    return GONIO_CHOSEN_KERNELS(set, detail::kernels_parts);
}

} // namespace gonio::transport
