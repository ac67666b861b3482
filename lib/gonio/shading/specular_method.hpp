// Ways to take the specular luminance of an area light, by name.
#pragma once

#include <cstdint>

namespace gonio::shading {

// ltc: specular_ltc.hpp; the others, kept for comparison: specular_named.hpp.
enum class SpecularMethod : std::uint8_t {
    ltc,
    representative_point,
    dominant_direction,
    specular_d,
    spherical_hack,
    sun_disk
};

// Where none is asked for.
inline constexpr SpecularMethod standard_specular_method = SpecularMethod::representative_point;

// Luminance towards the eye per luminance of the light is scale·(f0 + (f90 − f0)·grazing); scale is that of F = 1.
template<class S>
struct SpecularLuminance {
    S scale, grazing;
};

} // namespace gonio::shading
