#include <gonio/shading/kernels_specular.hpp>
#include <gonio/shading/kernels_specular_impl.hpp>
#include <gonio/simd/kernel_choice.hpp>

namespace gonio::shading {

const SpecularKernels& specular_kernels(simd::InstructionSet set) {
    return GONIO_CHOSEN_KERNELS(set, detail::specular_kernels);
}

} // namespace gonio::shading
