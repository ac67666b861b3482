// The part of a round light that a capsule hides.
#pragma once

#include <gonio/scene/primitives.hpp>

#include <glm/vec3.hpp>

namespace gonio {

// ∫ n·ω dω [sr] over the overlap of a cap (half angle in [0, π/2] about a unit axis) and a capsule seen from the
// origin, which lies outside the capsule: the illuminance of that overlap at a luminance of 1 if all of it is above the
// horizon of n. Closed form: the outline integral of area lights over the arcs that bound the overlap. The capsule's
// outline is two great arcs, in the planes tangent to its side, and an arc of each end's circle
// (shading/irradiance_tube.hpp); the cap cuts each circle in one interval, and four circles cut the cap.
double projected_capsule_overlap(const glm::dvec3& cap_axis, double half_angle, const Capsule& capsule,
                                 const glm::dvec3& normal);

} // namespace gonio
