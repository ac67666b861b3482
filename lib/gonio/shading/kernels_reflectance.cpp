#include <gonio/shading/kernels_reflectance.hpp>
#include <gonio/shading/kernels_reflectance_impl.hpp>
#include <gonio/simd/kernel_choice.hpp>

namespace gonio::shading {

const ReflectanceKernels& reflectance_kernels(simd::InstructionSet set) {
    return GONIO_CHOSEN_KERNELS(set, detail::reflectance_kernels);
}

} // namespace gonio::shading
