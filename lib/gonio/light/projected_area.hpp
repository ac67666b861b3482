// The projected area of a luminous opening: what divides an intensity to give a luminance.
#pragma once

#include <gonio/light/opening.hpp>

#include <glm/vec3.hpp>

#pragma GCC visibility push(default)
namespace gonio {

// The area of the opening as it is seen from far away along `direction`, of length 1, in the frame of the luminaire
// (−Z is the nadir) [m²]. Rectangles, disks and ellipses are seen from below, an upright disk from both sides. A box
// has sides of their own heights and no lid: from above it shows the sides alone. Cylinders, spheres and ellipsoids are
// exact and closed. 0 for a point.
double projected_area_m2(const Opening& opening, const glm::dvec3& direction);

} // namespace gonio
#pragma GCC visibility pop
