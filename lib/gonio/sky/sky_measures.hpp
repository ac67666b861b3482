// What a light meter would read under a sky, and where the sky is brightest.
#pragma once

#include <gonio/base/quantity.hpp>
#include <gonio/sky/environment_map.hpp>
#include <gonio/sky/sky.hpp>
#include <gonio/sky/sky_direction.hpp>

#include <glm/vec3.hpp>

#include <array>
#include <optional>

#pragma GCC visibility push(default)
namespace gonio {

// The greatest luminance, and the share of all light (∫ L dω over the sphere, without the sun) from within
// spot_radius_deg of it.
struct BrightestSpot {
    glm::dvec3 direction{0.0, 0.0, 1.0};
    Nits luminance;
    double share = 0.0;
};

// Of all light: a sun or a lamp in the pixels of an image. A clear sky has less than a hundredth around its sun.
inline constexpr double sun_like_share = 0.25;

// The brightest spot of an image if it has at least that share of the light; in the image's own frame. One pass over
// the pixels where it has not.
std::optional<BrightestSpot> sun_like_spot(const EnvironmentMap& map, unsigned threads = 0);

// The measures of a sky that `gonio sky` prints.
struct SkyMeasures {
    Lux horizontal;              // of a plane that faces up
    std::array<Lux, 4> vertical; // of walls that face north, east, south and west
    Nits mean;                   // Sky::mean()
    Nits zenith;
    std::optional<BrightestSpot> spot; // nothing if all directions are equal; of an image the brightest texel
    glm::dvec3 color{0.0};             // of the light on a sphere: linear Rec.709 of luminance 1; 0 of a black sky
};

// Of SkyMeasures::vertical: north, east, south, west.
inline constexpr std::array wall_azimuths_deg{0.0, 90.0, 180.0, 270.0};

// Without the sun. Some milliseconds for analytic skies; the share of their spot is within 1e-4.
SkyMeasures measure(const Sky& sky, unsigned threads = 0);

} // namespace gonio
#pragma GCC visibility pop
