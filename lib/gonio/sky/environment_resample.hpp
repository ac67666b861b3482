// Environments in other layouts and sizes, and skies as environments.
//
// Resampling is exact and keeps the energy: a texel of the result holds the mean of the source over its solid angle, by
// the areas in which texels of the two overlap on the sphere. These are polygons with great circles as sides; a
// lat-long's parallels are chords of at least 2048 slices, and each texel's light is scaled from its polygon to its
// solid angle. So ∫ L dω is the same to the rounding of the pixels, and a uniform image stays uniform within 4e-6.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/sky/environment_map.hpp>
#include <gonio/sky/sky.hpp>
#include <gonio/sky/sun_light.hpp>

#pragma GCC visibility push(default)
namespace gonio {

// The greatest number of texels: a limit of its own, so that a size is refused before memory runs out.
Result<EnvironmentGrid> environment_grid(EnvironmentLayout layout, int side);

// The image in another layout or size, turned so that azimuths grow by `rotation`; nits_per_unit stays. About half a
// microsecond for each overlap, and some (source texels + result texels) × 2 of them. The same for any number of
// threads; 0: all.
EnvironmentMap resampled(const EnvironmentMap& source, const EnvironmentGrid& to, Radians rotation = {},
                         unsigned threads = 0);

// The sky without its sun as pixels in cd/m²: means over the texels by Gauss quadrature, divided where it has not
// converged: within 1e-6 of each mean, but for texels across the horizon of an odd size.
EnvironmentMap rendered(const Sky& sky, const EnvironmentGrid& to, unsigned threads = 0);

// Any sky without the sun beside it on this grid: rendered, resampled, or its own image where that is the same.
EnvironmentMap environment_of(const Sky& sky, const EnvironmentGrid& to, unsigned threads = 0);

// The image with the disc of the sun in it, its light spread over the texels that it covers. The illuminance of a plane
// that faces the sun grows by the sun's, as far as the texels do not blur it.
EnvironmentMap with_sun(const EnvironmentMap& map, const SunLight& sun);

} // namespace gonio
#pragma GCC visibility pop
