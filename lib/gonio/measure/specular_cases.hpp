// Poses of receivers, view directions and GGX roughnesses in front of area lights, for measuring specular methods.
#pragma once

#include <gonio/measure/area_cases.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace gonio::measure {

// Half of the view directions see the light's mirror image: their mirrored ray passes through the light or within twice
// its size of it. The others are any direction above the surface.
struct SpecularCases {
    static constexpr std::size_t group_size = AreaCases::group_size; // receivers of one light and one α

    AreaCases area;
    std::array<std::vector<float>, 3> view; // unit within rounding, n·v > 0.01
    std::vector<float> alpha;               // of each light, in [0.01, 1], log-uniform
    std::vector<Stratum> stratum;           // same as area.stratum

    [[nodiscard]] std::size_t size() const { return stratum.size(); }
    // Views into this object: the receivers of area.lights[group], with their view directions.
    [[nodiscard]] shading::Surfaces surfaces(std::size_t group) const;
};

// As area_cases; kind may also be sphere. Poses whose light is wholly below the horizon, or too close to be visible,
// are kept like any other, with their true value.
SpecularCases specular_cases(shading::LightConstants::Kind kind, std::size_t count, std::uint64_t seed);

// At least `count` poses of one stratum.
SpecularCases specular_cases_of(shading::LightConstants::Kind kind, Stratum stratum, std::size_t count,
                                std::uint64_t seed);

} // namespace gonio::measure
