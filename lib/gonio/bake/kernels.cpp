#include <gonio/bake/kernels.hpp>
#include <gonio/simd/kernel_choice.hpp>

namespace gonio::bake {

const Kernels& kernels(simd::InstructionSet set) {
    return GONIO_CHOSEN_KERNELS(set, detail::kernels);
}

} // namespace gonio::bake
