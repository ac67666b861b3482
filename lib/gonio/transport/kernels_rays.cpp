#include <gonio/simd/kernel_choice.hpp>
#include <gonio/transport/kernels_rays.hpp>
#include <gonio/transport/kernels_rays_impl.hpp>

namespace gonio::transport {

const RayKernels& ray_kernels(simd::InstructionSet set) {
    return GONIO_CHOSEN_KERNELS(set, detail::kernels_rays);
}

} // namespace gonio::transport
