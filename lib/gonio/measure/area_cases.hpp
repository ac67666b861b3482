// Poses of receivers in front of disk, rectangle and tube lights, for measuring methods.
//
// Each light is at the origin, has individual sizes and an individual orientation, and is seen by a group of receivers,
// as the kernels expect. All numbers are floats, so that every precision gets the same pose; unit vectors have unit
// length to float rounding.
#pragma once

#include <gonio/measure/sphere_cases.hpp>
#include <gonio/shading/kernels.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace gonio::measure {

struct AreaCases {
    static constexpr std::size_t group_size = 256; // receivers of one light

    std::vector<shading::LightConstants> lights; // the last group may have fewer receivers
    std::array<std::vector<float>, 3> position;
    std::array<std::vector<float>, 3> normal;
    // As for spheres, using the sphere about the light. above, straddling and below: from 1.05 to 30 of its radii; far:
    // beyond that up to 1e6. near: from 1e-3 to 0.3 of its radius off the light's surface, any tilt.
    std::vector<Stratum> stratum;

    [[nodiscard]] std::size_t size() const { return stratum.size(); }
    // Views into this object: the receivers of lights[group].
    [[nodiscard]] shading::Surfaces surfaces(std::size_t group) const;
};

// `count` poses in front of lights of kind sphere, disk, ellipse or rectangle (sides 1:1 to 100:1) or tube (length 0.01
// to 100 radii), sizes from 1 cm to 100 m; one-sided lights are seen from the front. The same seed gives the same poses
// on every machine.
AreaCases area_cases(shading::LightConstants::Kind kind, std::size_t count, std::uint64_t seed);

// At least `count` poses of one stratum, in front of the same lights as those of area_cases.
AreaCases area_cases_of(shading::LightConstants::Kind kind, Stratum stratum, std::size_t count, std::uint64_t seed);

// Radius of the bounding sphere about the light's position.
double bounding_radius(const shading::LightConstants& light);

} // namespace gonio::measure
