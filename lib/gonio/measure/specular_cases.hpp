// Poses of receivers, eyes and GGX roughnesses before area lights, to measure specular methods on.
#pragma once

#include <gonio/measure/area_cases.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace gonio::measure {

// Half of the eyes see the light's mirror image: their mirrored ray passes through the light or within twice its size
// of it. The others look from anywhere over the surface.
struct SpecularCases {
    static constexpr std::size_t group_size = AreaCases::group_size; // receivers of one light and one α

    AreaCases area;
    std::array<std::vector<float>, 3> view; // unit within rounding, n·v > 0.01
    std::vector<float> alpha;               // of each light, in [0.01, 1], even in its logarithm
    std::vector<Stratum> stratum;           // as area.stratum

    [[nodiscard]] std::size_t size() const { return stratum.size(); }
    // Views into this object of the receivers of area.lights[group], eyes included.
    [[nodiscard]] shading::Surfaces surfaces(std::size_t group) const;
};

// As area_cases; kind may be sphere too. Poses whose light is all below the horizon, or too close to see, count like
// others: their truth is what it is.
SpecularCases specular_cases(shading::LightConstants::Kind kind, std::size_t count, std::uint64_t seed);

// Poses of one stratum, at least `count` of them.
SpecularCases specular_cases_of(shading::LightConstants::Kind kind, Stratum stratum, std::size_t count,
                                std::uint64_t seed);

} // namespace gonio::measure
