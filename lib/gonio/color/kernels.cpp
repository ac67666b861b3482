#include <gonio/color/kernels.hpp>
#include <gonio/color/kernels_impl.hpp>
#include <gonio/simd/kernel_choice.hpp>

namespace gonio::color {

RgbConstants rgb_constants(const RgbSpace& space) {
    // X = 2.25 A, Y = 1, Z = 3 B − 0.75 A − 5, with A = u'/v' and B = 1/v'.
    const glm::dvec3& x = space.from_xyz[0];
    const glm::dvec3& y = space.from_xyz[1];
    const glm::dvec3& z = space.from_xyz[2];
    const glm::dvec3 a = 2.25 * x - 0.75 * z;
    const glm::dvec3 b = 3.0 * z;
    const glm::dvec3 c = y - 5.0 * z;
    RgbConstants constants;
    for (int i = 0; i < 3; ++i) {
        constants.a[i] = static_cast<float>(a[i]);
        constants.b[i] = static_cast<float>(b[i]);
        constants.c[i] = static_cast<float>(c[i]);
    }
    return constants;
}

const Kernels& kernels(simd::InstructionSet set) {
    return GONIO_CHOSEN_KERNELS(set, detail::kernels);
}

} // namespace gonio::color
