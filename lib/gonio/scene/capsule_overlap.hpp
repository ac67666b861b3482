// What a capsule hides of a round light.
#pragma once

#include <gonio/scene/primitives.hpp>

#include <glm/vec3.hpp>

namespace gonio {

// ∫ n·ω dω over what a cap of half angle in [0, π/2] about a unit axis and a capsule have in common [sr], the capsule
// seen from the origin, which lies outside of it: the illuminance that it gives at a luminance of 1 where all of it is
// above the horizon of n. Closed form: the outline integral of area lights over the arcs that bound it. The capsule's
// outline is two great arcs, in the planes that touch its side, and an arc of each end's circle
// (shading/irradiance_tube.hpp); the cap cuts a circle in one interval, and is cut by four circles.
double projected_capsule_overlap(const glm::dvec3& cap_axis, double half_angle, const Capsule& capsule,
                                 const glm::dvec3& normal);

} // namespace gonio
