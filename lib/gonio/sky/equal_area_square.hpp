// Environments as squares with texels of equal solid angle.
//
// The mapping is that of P. Clarberg, "Fast Equal-Area Mapping of the (Hemi)Sphere using SIMD" (2008), as pbrt-v4 looks
// it up: the zenith in the middle, east to the right, north below, the nadir in the corners. Above the horizon
// the unit direction (x, y, z) lies at (±u, ±v) in [−1, 1]², with the signs of x and y, where u + v = √(1 − z) and
// v/(u + v) = 2/π atan(|y|/|x|); below it at (±(1 − v), ±(1 − u)) of its mirror image.
#pragma once

#include <gonio/base/image.hpp>
#include <gonio/sky/environment_map.hpp>

namespace gonio {

// A lat-long with an even height as a square of `side` texels, three channels in the units of its pixels. Exact:
// parallels and meridians are straight lines in the square, and areas are shares of the solid angle; each texel is the
// mean of the parts of source texels in it. About 50 ns for each texel of the source.
Image equal_area_square(const EnvironmentMap& latlong, int side);

} // namespace gonio
