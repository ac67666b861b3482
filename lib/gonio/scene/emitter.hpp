// Lights as objects: where a ray meets the luminous surface of a light.
#pragma once

#include <gonio/light/light.hpp>
#include <gonio/scene/camera.hpp>

#include <optional>

namespace gonio {

// Distance along a unit direction to the luminous surface; nothing where the ray misses it or meets its dark side, or
// where the shape has no surface at a finite distance (punctual lights, the sun).
std::optional<double> distance_to(const Light& light, const Ray& ray);

// How far the luminous surface extends from the light's centre along a unit direction [m]; 0 if there is none.
double reach_along(const Light& light, const glm::dvec3& direction);

} // namespace gonio
