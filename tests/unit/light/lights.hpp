// Lights from short texts, for tests.
#pragma once

#include <gonio/light/light.hpp>

namespace gonio {

inline Light light_of(const char* shape, const char* intensity, glm::dvec3 position,
                      glm::dvec3 direction = {0.0, 0.0, -1.0}, glm::dvec3 up = {0.0, 1.0, 0.0}) {
    Diagnostics diagnostics;
    LightDescription description;
    description.shape = parse_shape(shape).value();
    description.intensity = parse_photometric_value(intensity).value();
    description.position = position;
    description.direction = direction;
    description.up = up;
    return resolve_light(description, diagnostics).value();
}

} // namespace gonio
