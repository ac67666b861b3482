// Seeded poses of an area light, a receiver and an eye, for checking the reference integrator against its own estimate.
#pragma once

#include <gonio/base/frame.hpp>
#include <gonio/light/light.hpp>
#include <gonio/measure/random.hpp>
#include <gonio/scene/material.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gonio::test {

struct ReferenceCase {
    Light light;
    glm::dvec3 normal{0.0, 0.0, 1.0};
    glm::dvec3 view{0.0, 0.0, 1.0};
    Material material;
};

inline glm::dvec3 random_direction(measure::Random& random) {
    const double z = random.uniform(-1.0, 1.0);
    const double phi = random.uniform(0.0, 2.0 * std::numbers::pi);
    const double r = std::sqrt(1.0 - z * z);
    return {r * std::cos(phi), r * std::sin(phi), z};
}

inline double log_uniform(measure::Random& random, double low, double high) {
    return std::exp(random.uniform(std::log(low), std::log(high)));
}

inline Shape area_shape(unsigned kind, double size, measure::Random& random) {
    switch (kind % 4) {
    case 0:
        return SphereShape{Meters(size)};
    case 1:
        return DiskShape{Meters(size), random.uniform() < 0.5};
    case 2:
        return RectShape{Meters(2.0 * size), Meters(2.0 * size * log_uniform(random, 1e-3, 1.0)),
                         random.uniform() < 0.5};
    default:
        return TubeShape{Meters(size * log_uniform(random, 1e-3, 1.0)), Meters(2.0 * size)};
    }
}

// Number `index` of a series. Shapes in turn; distances of 0.03 to 300 sizes, a third of them with a light that fills
// much of the sky; alpha from 1e-4 to 1; half of the lobes point to the light; views from grazing to along n.
inline ReferenceCase reference_case(unsigned index, std::uint64_t seed = 1) {
    measure::Random random(seed * 1'000'003 + index);
    ReferenceCase made;
    Light& light = made.light;
    light.shape = area_shape(index, log_uniform(random, 0.1, 10.0), random);
    light.color = {1.0, 1.0, 1.0};
    light.luminance = Nits(1.0);
    const double size = std::visit(
        [](const auto& s) {
            if constexpr (requires { s.width; })
                return 0.5 * s.width.value;
            else if constexpr (requires { s.length; })
                return 0.5 * s.length.value;
            else if constexpr (requires { s.radius; })
                return s.radius.value;
            else
                return 1.0;
        },
        light.shape);
    const double distance = size * log_uniform(random, 0.03, random.uniform() < 0.33 ? 2.0 : 300.0);
    light.frame = aimed_frame(random_direction(random) * distance, random_direction(random), random_direction(random));
    made.normal = random_direction(random);
    const glm::dvec3 to_light = glm::normalize(light.frame.origin);
    // Half of the lights straddle the horizon or are close to it.
    if (random.uniform() < 0.5)
        made.normal = glm::normalize(made.normal - to_light * glm::dot(made.normal, to_light) * random.uniform());
    const double cosine = std::max(random.uniform() < 0.5 ? random.uniform() : log_uniform(random, 1e-4, 1.0), 1e-4);
    glm::dvec3 across = glm::normalize(glm::cross(made.normal, random_direction(random)));
    if (random.uniform() < 0.5 && glm::dot(made.normal, to_light) > 0.0) {
        // The mirrored view within a size of the light.
        const glm::dvec3 toward =
            glm::normalize(light.frame.origin + random_direction(random) * size * random.uniform(0.0, 1.5));
        if (glm::dot(toward, made.normal) > 1e-4)
            made.view = 2.0 * glm::dot(toward, made.normal) * made.normal - toward;
    } else {
        made.view = made.normal * cosine + across * std::sqrt(1.0 - cosine * cosine);
    }
    made.view = glm::normalize(made.view);
    const double alpha = log_uniform(random, 1e-4, 1.0);
    FrostbiteMaterial material;
    material.base = glm::dvec3(random.uniform());
    material.smoothness = 1.0 - std::sqrt(alpha);
    material.metal = random.uniform() < 0.3 ? 1.0 : 0.0;
    made.material = material;
    return made;
}

} // namespace gonio::test
