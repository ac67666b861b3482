// Lights as bodies: where a ray meets the luminous surface of a light, and how large it is for a shadow.
#pragma once

#include <gonio/light/light.hpp>
#include <gonio/scene/camera.hpp>

#include <optional>

namespace gonio {

// Distance along a unit direction to the luminous surface; nothing where it is missed, seen from its dark side, or
// where the shape has no surface at a finite distance (punctual lights, the sun).
std::optional<double> distance_to(const Light& light, const Ray& ray);

// Radius of the sphere that shows as large a disk as the shape shows along its direction; 0 for punctual shapes. Soft
// shadows take this sphere for the light: exact for spheres, near for what is as wide as it is high.
double shadow_radius(const Light& light);

} // namespace gonio
