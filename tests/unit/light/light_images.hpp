// Shared by the tests of images as masks: images that are made, and lights with them.
#pragma once

#include <gonio/light/light.hpp>
#include <gonio/light/light_image.hpp>

#include "shapes.hpp"

#include <cmath>
#include <memory>
#include <string>
#include <variant>

namespace gonio::test {

// One channel: a ramp, a dark half and noise, so that no part of it is like another.
inline Image grey_image(int width, int height) {
    Image image(width, height, 1);
    unsigned state = 12345;
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column) {
            state = state * 1664525U + 1013904223U;
            const double noise = static_cast<double>(state >> 8U) / static_cast<double>(1U << 24U);
            const double ramp = (column + 0.5) / width;
            const double dark = row > height / 2 && column > width / 2 ? 0.02 : 1.0;
            *image.at(column, row) = static_cast<float>(3.0 * dark * (0.3 * noise + ramp));
        }
    return image;
}

inline Image colored_image(int width, int height) {
    Image image(width, height, 3);
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column) {
            float* const rgb = image.at(column, row);
            rgb[0] = column < width / 2 ? 1.0F : 0.1F;
            rgb[1] = static_cast<float>(row + 1) / static_cast<float>(height);
            rgb[2] = column < width / 2 ? 0.0F : 2.0F;
        }
    return image;
}

inline Shape with_image(const std::string& text, const Image& image) {
    Shape made = shape(text);
    const auto of = std::make_shared<const LightImage>(LightImage::create(image).value());
    std::visit(
        [&](auto& kind) {
            if constexpr (requires { kind.image; }) kind.image = of;
        },
        made);
    return made;
}

inline Light light_with_image(const std::string& text, const Image& image, const std::string& amount,
                              const glm::dvec3& color = glm::dvec3(1.0)) {
    LightDescription description;
    description.shape = with_image(text, image);
    description.intensity = parse_photometric_value(amount).value();
    description.color = color;
    Diagnostics ignored;
    return resolve_light(description, ignored).value();
}

} // namespace gonio::test
