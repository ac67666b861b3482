#include <gonio/color/rgb_space.hpp>
#include <gonio/preview/white_balance.hpp>

#include <glm/vec3.hpp>

#include <algorithm>
#include <cstddef>

namespace gonio {

namespace {

const RgbSpace& rec709() {
    return *find_rgb_space("rec709");
}

} // namespace

glm::dmat3 white_balance(Xy white) {
    return rec709().from_xyz * bradford(white, d65_white) * rec709().to_xyz;
}

Xy gray_world_white(const Image& exposed) {
    const Image* const pictures[] = {&exposed};
    return gray_world_white(pictures);
}

Xy gray_world_white(std::span<const Image* const> exposed) {
    const glm::dvec3 weights = luminance_row(rec709());
    glm::dvec3 sum(0.0);
    for (const Image* const picture : exposed)
        for (std::size_t i = 0; i + 2 < picture->pixels.size(); i += 3) {
            const glm::dvec3 rgb(picture->pixels[i], picture->pixels[i + 1], picture->pixels[i + 2]);
            const double luminance = weights.x * rgb.x + weights.y * rgb.y + weights.z * rgb.z;
            if (luminance > 0.0) sum += rgb / std::max(luminance, 1.0);
        }
    const Result<Uv> mean = uv_of_rgb(sum, rec709());
    return mean ? to_xy(*mean) : d65_white;
}

void balance(Image& image, const glm::dmat3& matrix) {
    for (std::size_t i = 0; i + 2 < image.pixels.size(); i += 3) {
        float* const pixel = image.pixels.data() + i;
        const glm::dvec3 balanced = matrix * glm::dvec3(pixel[0], pixel[1], pixel[2]);
        for (int channel = 0; channel < 3; ++channel)
            pixel[channel] = static_cast<float>(std::max(balanced[channel], 0.0));
    }
}

} // namespace gonio
