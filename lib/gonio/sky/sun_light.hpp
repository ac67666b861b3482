// The sun beside a sky: no sky contains its disc, since no table of directions resolves half a degree.
#pragma once

#include <gonio/base/quantity.hpp>

#include <glm/vec3.hpp>

#pragma GCC visibility push(default)
namespace gonio {

// The mean apparent diameter of the sun's disc, which has 6.8018e-5 sr.
inline constexpr Radians sun_diameter = degrees(0.5332);

// A sun: a disc that is infinitely far away.
struct SunLight {
    glm::dvec3 direction{0.0, 0.0, 1.0}; // unit, towards the sun
    Lux illuminance;                     // on a plane perpendicular to it
    glm::dvec3 color{1.0};               // linear Rec.709 of luminance 1
    Radians diameter = sun_diameter;
};

} // namespace gonio
#pragma GCC visibility pop
