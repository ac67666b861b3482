// Lights as objects: where a ray meets the luminous surface of a light.
#pragma once

#include <gonio/light/light.hpp>
#include <gonio/scene/camera.hpp>

#include <glm/vec3.hpp>

#include <optional>
#include <vector>

namespace gonio {

// Distance along a unit direction to the luminous surface; nothing where the ray misses it or meets its dark side, or
// where the shape has no surface at a finite distance (punctual lights, the sun).
std::optional<double> distance_to(const Light& light, const Ray& ray);

// How far the luminous surface extends from the light's centre along a unit direction [m]; 0 if there is none.
double reach_along(const Light& light, const glm::dvec3& direction);

// Points whose convex hull, projected, the luminous surface is seen as, from where it is seen; polygons of 32 corners
// for round ones, with the area of disks, ellipses and spheres and the width of tubes and cylinders. The eye may look
// past the luminous side within it: into the end of a cylinder. Nothing without a surface at a finite distance, or
// inside it.
std::vector<glm::dvec3> outline_points(const Light& light, const glm::dvec3& eye);

} // namespace gonio
