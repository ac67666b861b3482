#include <gonio/preview/kernels_camera.hpp>
#include <gonio/preview/kernels_camera_impl.hpp>
#include <gonio/simd/kernel_choice.hpp>

namespace gonio::preview {

const CameraKernels& camera_kernels(simd::InstructionSet set) {
    return GONIO_CHOSEN_KERNELS(set, detail::kernels_camera);
}

} // namespace gonio::preview
