// Poses of a receiver in front of a sphere light, for measuring methods.
//
// The sphere has radius 1 and is at the origin: E/L depends on d/r and angles only, and the kernels take one light with
// many receivers. All numbers are floats, so that every precision gets the same pose; normals have unit length to float
// rounding.
#pragma once

#include <gonio/shading/kernels.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace gonio::measure {

// above, straddling, below: relative to the receiver's horizon, 1.01 ≤ d/r ≤ 30. near: d/r − 1 from 1e-6 to 0.1, any
// tilt. far: d/r from 30 to 1e6, half of them grazing.
enum class Stratum : std::uint8_t { above, straddling, below, near, far };
inline constexpr std::size_t stratum_count = 5;

const char* to_text(Stratum stratum);

struct SphereCases {
    std::array<std::vector<float>, 3> position;
    std::array<std::vector<float>, 3> normal;
    std::vector<Stratum> stratum;

    [[nodiscard]] std::size_t size() const { return stratum.size(); }
    // Views into this object.
    [[nodiscard]] shading::Surfaces surfaces() const;
    // The light that all of them see: radius 1, at the origin, luminance 1 nt.
    static shading::LightConstants light();
};

// `count` poses, cycling through the strata; the same seed gives the same poses on every machine.
SphereCases sphere_cases(std::size_t count, std::uint64_t seed);

// `count` poses of one stratum.
SphereCases sphere_cases_of(Stratum stratum, std::size_t count, std::uint64_t seed);

} // namespace gonio::measure
