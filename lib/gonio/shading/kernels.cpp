#include <gonio/shading/kernels.hpp>
#include <gonio/shading/kernels_impl.hpp>
#include <gonio/simd/kernel_choice.hpp>

namespace gonio::shading {

const Kernels& kernels(simd::InstructionSet set) {
    return GONIO_CHOSEN_KERNELS(set, detail::kernels);
}

} // namespace gonio::shading
